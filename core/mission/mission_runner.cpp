#include "core/mission/mission_runner.h"
