#include "core/modules/robot_modules.h"
