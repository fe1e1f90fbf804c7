// Pictures as JPEG files in memory, by libjpeg.
#pragma once

#include <string>

#include "core/sim/camera/picture.h"

namespace usar::sim {

/// `quality` 1 to 100. A picture of at least one pixel.
std::string jpegOf(const Picture& picture, int quality);

} // namespace usar::sim
