#include "core/mission/mission_score.h"
