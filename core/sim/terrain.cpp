#include "core/sim/terrain.h"
