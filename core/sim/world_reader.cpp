#include "core/sim/world_reader.h"
