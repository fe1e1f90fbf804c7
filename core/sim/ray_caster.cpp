#include "core/sim/ray_caster.h"
