#include "core/sim/simulation.h"
