#include "core/mission/robot_session.h"
