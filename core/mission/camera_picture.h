// A frame of the image server as a picture that can be shown.
#pragma once

#include <QByteArray>
#include <QImage>

#include "core/base/result.h"
#include "core/link/image_type.h"

namespace usar::mission {

/// JPEG or raw (usarsim-protocol 6.1). What cannot be read, or is larger than 4096 pixels a side, is an error.
Result<QImage> cameraPictureOf(link::ImageType type, const QByteArray& data);

} // namespace usar::mission
