#include "core/mapping/scan_integrator.h"
