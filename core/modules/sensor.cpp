#include "core/modules/sensor.h"
