#include "core/mission/map_picture.h"
