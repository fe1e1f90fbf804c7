#include "core/sim/world_generator.h"
