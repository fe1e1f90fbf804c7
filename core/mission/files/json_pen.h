// Appends JSON to a text, for output of many small objects.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace usar::mission {

/// Appends JSON to a text, which must outlive it. A QJsonDocument for each line of a log would take ten times as long
/// as reading the line.
class JsonPen {
public:
    explicit JsonPen(std::string& out) : out_(out) {}

    void raw(std::string_view json) { out_.append(json); }
    void key(std::string_view name) {
        raw("\"");
        raw(name);
        raw("\":");
    }
    /// A text in Latin-1, the encoding of the wire.
    void text(std::string_view latin1) {
        quoted(latin1, [this](char c) { // The two bytes of UTF-8.
            const auto byte = static_cast<unsigned char>(c);
            out_ += static_cast<char>(0xc0 | (byte >> 6));
            out_ += static_cast<char>(0x80 | (byte & 0x3f));
        });
    }
    void utf8(std::string_view text) {
        quoted(text, [this](char c) { out_ += c; });
    }
    void number(double value) {
        if (!std::isfinite(value))
            return raw("\"nan\"");
        std::array<char, 32> digits;
        out_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    }
    void number(std::uint64_t value) {
        std::array<char, 24> digits;
        out_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    }
    /// A comma, except before the first of several things.
    void next(bool& first) {
        if (!std::exchange(first, false))
            out_ += ',';
    }

private:
    /// Most texts are plain for their whole length, so that runs of plain characters are appended at once.
    template <class NotAscii>
    void quoted(std::string_view text, NotAscii not_ascii) {
        out_ += '"';
        while (!text.empty()) {
            const auto special = std::ranges::find_if_not(text, isPlain);
            const auto plain = static_cast<std::size_t>(special - text.begin());
            out_.append(text.substr(0, plain));
            text.remove_prefix(plain);
            if (text.empty())
                break;
            if (static_cast<unsigned char>(text.front()) < 0x80)
                escape(text.front());
            else
                not_ascii(text.front());
            text.remove_prefix(1);
        }
        out_ += '"';
    }
    static bool isPlain(char c) { return c >= 0x20 && c < 0x7f && c != '"' && c != '\\'; }
    void escape(char c) {
        constexpr std::string_view digits = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            out_ += '\\';
        if (byte >= 0x20)
            out_ += c;
        else
            out_.append({'\\', 'u', '0', '0', digits[byte >> 4], digits[byte & 15]});
    }

    std::string& out_;
};

} // namespace usar::mission
