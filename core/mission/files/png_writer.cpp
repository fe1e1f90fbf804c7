#include "core/mission/files/png_writer.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <zlib.h>

namespace usar::mission {

namespace {

constexpr std::size_t piece_bytes = 1u << 16;
/// A higher level takes three times as long to save a tenth of the size.
constexpr int fast_compression = 3;
constexpr char as_difference_from_above = 2; // RFC 2083, 6.4

std::string bigEndian(std::uint32_t value) {
    return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
            static_cast<char>(value)};
}

bool writeChunk(const mapping::ByteSink& sink, std::string_view type, std::string_view data) {
    const std::string bytes = std::string(type) + std::string(data);
    const auto checksum = ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    const std::string whole =
        bigEndian(static_cast<std::uint32_t>(data.size())) + bytes + bigEndian(static_cast<std::uint32_t>(checksum));
    return sink(whole.data(), whole.size());
}

/// Compresses what it is given into chunks of pixels.
class Pixels {
public:
    explicit Pixels(const mapping::ByteSink& sink) : sink_(sink) { ::deflateInit(&stream_, fast_compression); }
    ~Pixels() { ::deflateEnd(&stream_); }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;

    bool add(const std::vector<unsigned char>& row) { return compress(row.data(), row.size(), Z_NO_FLUSH); }
    bool finish() { return compress(nullptr, 0, Z_FINISH); }

private:
    bool compress(const unsigned char* bytes, std::size_t count, int flush) {
        stream_.next_in = const_cast<Bytef*>(bytes);
        stream_.avail_in = static_cast<uInt>(count);
        do {
            stream_.next_out = reinterpret_cast<Bytef*>(piece_.data()) + filled_;
            stream_.avail_out = static_cast<uInt>(piece_.size() - filled_);
            const int result = ::deflate(&stream_, flush);
            filled_ = piece_.size() - stream_.avail_out;
            if ((filled_ == piece_.size() || result == Z_STREAM_END) && !writeOut())
                return false;
            if (result == Z_STREAM_END)
                return true;
        } while (stream_.avail_in > 0 || flush == Z_FINISH);
        return true;
    }
    bool writeOut() {
        const std::size_t count = std::exchange(filled_, 0);
        return writeChunk(sink_, "IDAT", {piece_.data(), count});
    }

    const mapping::ByteSink& sink_;
    ::z_stream stream_{};
    std::vector<char> piece_ = std::vector<char>(piece_bytes);
    std::size_t filled_ = 0;
};

bool writeHead(const QImage& picture, const mapping::ByteSink& sink) {
    constexpr std::string_view magic{"\x89PNG\r\n\x1a\n", 8};
    constexpr std::string_view eight_bit_rgb{"\x08\x02\x00\x00\x00", 5};
    const auto dots = [](int per_meter) { return bigEndian(static_cast<std::uint32_t>(per_meter)); };
    if (!sink(magic.data(), magic.size()) ||
        !writeChunk(sink, "IHDR",
                    bigEndian(static_cast<std::uint32_t>(picture.width())) +
                        bigEndian(static_cast<std::uint32_t>(picture.height())) + std::string(eight_bit_rgb)) ||
        !writeChunk(sink, "pHYs", dots(picture.dotsPerMeterX()) + dots(picture.dotsPerMeterY()) + '\1'))
        return false;
    for (const QString& key : picture.textKeys()) {
        const std::string plain_utf8(5, '\0'); // The keyword's end, no compression, no language.
        if (!writeChunk(sink, "iTXt", key.toStdString() + plain_utf8 + picture.text(key).toStdString()))
            return false;
    }
    return true;
}

} // namespace

bool writePng(const QImage& picture, const mapping::ByteSink& sink) {
    const QImage opaque = picture.convertToFormat(QImage::Format_RGB888);
    if (opaque.isNull() || !writeHead(picture, sink))
        return false;
    const std::size_t width = 3 * static_cast<std::size_t>(opaque.width());
    std::vector<unsigned char> row(1 + width);
    row[0] = as_difference_from_above;
    const std::vector<unsigned char> nothing(width);
    const unsigned char* above = nothing.data();
    Pixels pixels(sink);
    for (int y = 0; y < opaque.height(); ++y) {
        const unsigned char* const line = opaque.constScanLine(y);
        for (std::size_t i = 0; i < width; ++i)
            row[1 + i] = static_cast<unsigned char>(line[i] - above[i]);
        if (!pixels.add(row))
            return false;
        above = line;
    }
    return pixels.finish() && writeChunk(sink, "IEND", {});
}

} // namespace usar::mission
