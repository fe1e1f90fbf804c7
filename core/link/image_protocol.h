// The words of the image server's protocol (usarsim-protocol 6.1), as values and bytes.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>

#include <QByteArray>

#include "core/link/image_type.h"
#include "core/sim/camera/picture.h"

namespace usar::link {

/// One frame. Without a rectangle the whole picture.
struct ImageRequest {
    struct Part {
        std::uint32_t x = 0, y = 0, width = 0, height = 0;
        bool operator==(const Part&) const = default;
    };
    std::optional<Part> part{};
    bool operator==(const ImageRequest&) const = default;
};

/// Finds requests in what a client sends, in any chunks; skips bytes that begin none. Keeps 17 bytes at most.
class ImageRequestReader {
public:
    void feed(std::string_view bytes, std::deque<ImageRequest>& found);

private:
    QByteArray pending_;
};

/// What a frame is made of, big-endian.
QByteArray frameOf(const sim::Picture& picture, ImageType type);

/// What a client asks with.
QByteArray bytesOf(const ImageRequest& request);

} // namespace usar::link
