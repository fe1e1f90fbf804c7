// Conversion of an image server's frame to a picture that can be shown.
#pragma once

#include <QByteArray>
#include <QImage>

#include "core/base/result.h"
#include "core/link/image_type.h"

namespace usar::mission {

/// Decodes the data of a frame, JPEG or raw (protocol.md 6.1). Data that cannot be read, or a picture larger than
/// 4096 pixels a side, is an error.
Result<QImage> cameraPictureOf(link::ImageType type, const QByteArray& data);

} // namespace usar::mission
