// Encodes pictures as JPEG files in memory, with libjpeg.
#pragma once

#include <string>

#include "core/sim/camera/picture.h"

namespace usar::sim {

/// `quality` is 1 to 100. The picture must have at least one pixel.
std::string jpegOf(const Picture& picture, int quality);

} // namespace usar::sim
