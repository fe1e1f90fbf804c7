#include "core/mapping/raster_export.h"
