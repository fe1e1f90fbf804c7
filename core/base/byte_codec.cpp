#include "core/base/byte_codec.h"

namespace usar {

void appendVarint(std::string& out, std::uint64_t number) {
    while (number >= 0x80) {
        out += static_cast<char>(number | 0x80);
        number >>= 7;
    }
    out += static_cast<char>(number);
}

void appendBits(std::string& out, std::uint64_t bits) {
    const int leading = bits ? std::countl_zero(bits) / 8 : 8;
    const int trailing = bits ? std::countr_zero(bits) / 8 : 0;
    out += static_cast<char>(leading << 4 | trailing);
    for (int byte = trailing; byte < 8 - leading; ++byte)
        out += static_cast<char>(bits >> (8 * byte));
}

std::uint8_t ByteReader::byte() {
    if (at_ < bytes_.size())
        return static_cast<std::uint8_t>(bytes_[at_++]);
    failed_ = true;
    return 0;
}

std::uint64_t ByteReader::varint() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const std::uint8_t next = byte();
        number |= static_cast<std::uint64_t>(next & 0x7F) << shift;
        if (!(next & 0x80))
            return number;
    }
    failed_ = true;
    return 0;
}

std::uint64_t ByteReader::bits() {
    const std::uint8_t counts = byte();
    const int leading = counts >> 4;
    const int trailing = counts & 15;
    if (leading + trailing > 8)
        failed_ = true;
    std::uint64_t bits = 0;
    for (int at = trailing; at < 8 - leading && !failed_; ++at)
        bits |= static_cast<std::uint64_t>(byte()) << (8 * at);
    return bits;
}

std::string_view ByteReader::text(std::uint64_t length) {
    if (length > bytes_.size() - at_) {
        failed_ = true;
        return {};
    }
    const std::string_view text = bytes_.substr(at_, static_cast<std::size_t>(length));
    at_ += text.size();
    return text;
}

} // namespace usar
