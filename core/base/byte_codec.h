// Numbers and texts as few bytes, for formats of our own, and a reader of such bytes that trusts none of them.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace usar {

/// Maps numbers of small magnitude, including negative ones, to small unsigned numbers; unzigzag is the inverse.
inline std::uint64_t zigzag(std::int64_t number) {
    return (static_cast<std::uint64_t>(number) << 1) ^ static_cast<std::uint64_t>(number >> 63);
}
inline std::int64_t unzigzag(std::uint64_t number) {
    return static_cast<std::int64_t>(number >> 1) ^ -static_cast<std::int64_t>(number & 1);
}

/// Appends a number with seven bits per byte, the lowest first.
void appendVarint(std::string& out, std::uint64_t number);
/// Appends the eight bytes of a word, the lowest first, without the zero bytes at both ends. A byte before them holds
/// the numbers of omitted bytes: at the high end in its upper half, at the low end in its lower half.
void appendBits(std::string& out, std::uint64_t bits);
/// The same for the word that represents `number`.
inline void appendDouble(std::string& out, double number) {
    appendBits(out, std::bit_cast<std::uint64_t>(number));
}

/// Reads values from untrusted bytes. A missing or malformed value sets failed(), which stays set; the value itself is
/// then meaningless, so check failed() before using the values.
class ByteReader {
public:
    /// The bytes must outlive this object.
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t varint();
    /// Reads what appendBits wrote.
    std::uint64_t bits();
    double number() { return std::bit_cast<double>(bits()); }
    std::uint8_t byte();
    /// Reads `length` bytes as a view into the bytes.
    std::string_view text(std::uint64_t length);
    /// Reads all that is left.
    std::string_view rest() { return text(bytes_.size() - at_); }
    bool empty() const { return at_ == bytes_.size(); }
    bool failed() const { return failed_; }
    /// The number of bytes read so far.
    std::size_t used() const { return at_; }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

} // namespace usar
