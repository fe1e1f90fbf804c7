#include "core/mapping/height_map.h"
