#include "core/mission/result_writer.h"
