#include "core/server/image_protocol.h"

#include <array>

#include <QtEndian>

namespace usar::server {

namespace {

constexpr qsizetype part_bytes = 17; ///< 'U' and four numbers of 32 bits
/// JPEG quality by ImageType, as in the picture library of the first server.
constexpr std::array<int, 6> qualities{0, 100, 75, 50, 25, 10};

template <class Number>
void append(QByteArray& bytes, Number number) {
    const Number big = qToBigEndian(number);
    bytes.append(reinterpret_cast<const char*>(&big), sizeof big);
}

/// Encodes width and height (16 bits each, big-endian), then rows of blue, green, red, each row padded to a multiple of
/// four bytes.
QByteArray rawOf(const sim::Picture& picture) {
    QByteArray bytes;
    const int filling = (4 - 3 * picture.width_px % 4) % 4;
    bytes.reserve(4 + (3 * picture.width_px + filling) * picture.height_px);
    append(bytes, static_cast<quint16>(picture.width_px));
    append(bytes, static_cast<quint16>(picture.height_px));
    for (int y = 0; y < picture.height_px; ++y) {
        for (int x = 0; x < picture.width_px; ++x) {
            const std::uint8_t* const rgb = picture.at(x, y);
            bytes.append(static_cast<char>(rgb[2])).append(static_cast<char>(rgb[1])).append(static_cast<char>(rgb[0]));
        }
        bytes.append(filling, '\0');
    }
    return bytes;
}

} // namespace

void ImageRequestReader::feed(std::string_view bytes, std::deque<ImageRequest>& found) {
    for (const char byte : bytes) {
        if (pending_.isEmpty() ? byte != 'O' && byte != 'U' : pending_ == "O" && byte != 'K') {
            pending_.clear();
            if (byte != 'O' && byte != 'U')
                continue; // Does not begin a request.
        }
        pending_.append(byte);
        if (pending_ == "OK") {
            found.emplace_back();
            pending_.clear();
        } else if (pending_.size() == part_bytes) {
            const auto number = [this](qsizetype at) { return qFromBigEndian<quint32>(pending_.constData() + at); };
            found.push_back({ImageRequest::Part{number(1), number(5), number(9), number(13)}});
            pending_.clear();
        }
    }
}

QByteArray frameOf(const sim::Picture& picture, link::ImageType type) {
    const auto kind = static_cast<std::size_t>(type);
    const QByteArray data = type == link::ImageType::Raw
                                ? rawOf(picture)
                                : QByteArray::fromStdString(sim::jpegOf(picture, qualities[kind]));
    QByteArray frame;
    frame.reserve(link::frame_head_bytes + data.size());
    frame.append(static_cast<char>(type));
    append(frame, static_cast<quint32>(data.size()));
    return frame.append(data);
}

QByteArray bytesOf(const ImageRequest& request) {
    if (!request.part)
        return "OK";
    QByteArray bytes("U");
    for (const std::uint32_t number : {request.part->x, request.part->y, request.part->width, request.part->height})
        append(bytes, number);
    return bytes;
}

} // namespace usar::server
