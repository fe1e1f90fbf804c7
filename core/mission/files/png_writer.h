// Writes pictures of maps as PNG (RFC 2083).
#pragma once

#include <QImage>

#include "core/mapping/byte_stream.h"

namespace usar::mission {

/// Writes an opaque picture with its texts and its resolution. Each row says how it differs from the one above, because
/// cells of a map are squares of equal pixels. Qt tries all ways of saying so for each row, which takes more than twice
/// as long for files that are larger. False if the sink takes no more.
bool writePng(const QImage& picture, const mapping::ByteSink& sink);

} // namespace usar::mission
