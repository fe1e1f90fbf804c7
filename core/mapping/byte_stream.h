// Bytes of binary files: where they go, and how numbers become little-endian bytes.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace usar::mapping {

/// Takes the next bytes of a file; false if they cannot be written, after which nothing more may be sent.
using ByteSink = std::function<bool(const char* bytes, std::size_t count)>;

/// Collects a piece of a file before it is sent, with all numbers little-endian, whatever the machine is.
class ByteBuffer {
public:
    template <std::integral Number>
    void add(Number value) {
        const auto bits = static_cast<std::make_unsigned_t<Number>>(value);
        for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
            bytes_.push_back(static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * byte) & 0xffu));
    }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    /// The text without a final zero.
    void add(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
    /// The text in a field of this width, cut off or filled with zeros.
    void addField(std::string_view text, std::size_t width) {
        text = text.substr(0, width);
        add(text);
        addZeros(width - text.size());
    }
    void addZeros(std::size_t count) { bytes_.resize(bytes_.size() + count, '\0'); }

    std::size_t size() const { return bytes_.size(); }
    const std::vector<char>& bytes() const { return bytes_; }
    void reserve(std::size_t count) { bytes_.reserve(count); }
    void clear() { bytes_.clear(); }
    /// Sends everything and becomes empty.
    bool sendTo(const ByteSink& sink) {
        const bool taken = sink(bytes_.data(), bytes_.size());
        clear();
        return taken;
    }

private:
    std::vector<char> bytes_;
};

} // namespace usar::mapping
