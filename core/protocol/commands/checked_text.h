// Texts that cannot break a command line: nothing on the wire can quote a brace, a line end or, in a name, a space.
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace usar::protocol {

/// A Token is one word; a Name one word or nothing; a Text may have spaces inside, or be nothing.
enum class TextRule { Token, Name, Text };

/// Whether a value by this rule would come back from the wire as it is. Braces and control characters never do, nor do
/// spaces around it.
bool fits(TextRule rule, std::string_view text);
/// `text` without what does not fit; a Token may come out empty.
std::string fitted(TextRule rule, std::string_view text);
Error misfit(TextRule rule, std::string_view text);

template <TextRule rule>
class CheckedText {
public:
    /// A Token has no empty value.
    CheckedText() requires(rule != TextRule::Token) = default;
    /// Words of our own, which are right or a bug. What people or servers say goes through `make` or `mended`.
    template <std::size_t size>
    CheckedText(const char (&literal)[size]) : text_(literal) {
        assert(fits(rule, text_));
    }
    static Result<CheckedText> make(std::string_view text) {
        if (!fits(rule, text))
            return tl::unexpected(misfit(rule, text));
        return CheckedText(Fitting{std::string(text)});
    }
    /// Leaves out what does not fit.
    static CheckedText mended(std::string_view text) requires(rule != TextRule::Token) {
        return CheckedText(Fitting{fitted(rule, text)});
    }

    const std::string& text() const { return text_; }
    operator const std::string&() const { return text_; }
    operator std::string_view() const { return text_; }
    bool empty() const { return text_.empty(); }
    bool operator==(const CheckedText&) const = default;
    friend bool operator==(const CheckedText& a, const std::same_as<std::string> auto& b) { return a.text_ == b; }

private:
    struct Fitting {
        std::string text;
    };
    explicit CheckedText(Fitting fitting) : text_(std::move(fitting.text)) {}

    std::string text_;
};

using Token = CheckedText<TextRule::Token>;
using Name = CheckedText<TextRule::Name>;
using Text = CheckedText<TextRule::Text>;

} // namespace usar::protocol
