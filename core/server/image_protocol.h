// The messages of the image server's protocol (protocol.md 6.1), as values and as bytes.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include <QByteArray>

#include "core/link/image_type.h"
#include "core/sim/camera/picture.h"

namespace usar::server {

/// A request for one frame: of the whole picture, or of a part of it.
struct ImageRequest {
    /// Rectangle in pixels from the top left corner of the picture.
    struct Part {
        std::uint32_t x = 0, y = 0, width = 0, height = 0;
        bool operator==(const Part&) const = default;
    };
    std::optional<Part> part{};
    bool operator==(const ImageRequest&) const = default;
};

/// Finds requests in the bytes that a client sends, fed in chunks of any size; skips bytes that do not begin a request.
/// Buffers at most 17 bytes.
class ImageRequestReader {
public:
    /// Appends the requests that `bytes` complete to `found`.
    void feed(std::string_view bytes, std::deque<ImageRequest>& found);

private:
    QByteArray pending_;
};

/// Makes a complete frame: type, size of the data (big-endian), data.
QByteArray frameOf(const sim::Picture& picture, link::ImageType type);

/// Encodes a request as a client sends it.
QByteArray bytesOf(const ImageRequest& request);

} // namespace usar::server
