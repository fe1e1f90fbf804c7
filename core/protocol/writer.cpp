#include "core/protocol/writer.h"
