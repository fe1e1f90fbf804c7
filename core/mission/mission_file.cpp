#include "core/mission/mission_file.h"
