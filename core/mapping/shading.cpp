#include "core/mapping/shading.h"
