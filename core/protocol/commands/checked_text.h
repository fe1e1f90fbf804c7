// Texts that cannot break a command line: the protocol has no way to quote a brace, a line end or, in a name, a space.
#pragma once

#include <cassert>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace usar::protocol {

/// A Token is one word; a Name is one word or empty; a Text may be empty or contain spaces.
enum class TextRule { Token, Name, Text };

/// True if a value under this rule would come back unchanged from the wire. Braces, control characters and surrounding
/// spaces never do.
bool fits(TextRule rule, std::string_view text);
/// `text` without the characters that do not fit; a Token may become empty.
std::string fitted(TextRule rule, std::string_view text);
/// The error message for a text that does not fit.
Error misfit(TextRule rule, std::string_view text);

/// A text that is known to fit its rule.
template <TextRule rule>
class CheckedText {
public:
    /// The empty text. A Token cannot be empty.
    CheckedText() requires(rule != TextRule::Token) = default;
    /// For literals in our own code, of which a misfit is a bug (asserted). Texts from users or servers go through
    /// `make` or `mended`.
    template <std::size_t size>
    CheckedText(const char (&literal)[size]) : text_(literal) {
        assert(fits(rule, text_));
    }
    /// Returns an error if `text` does not fit.
    static Result<CheckedText> make(std::string_view text) {
        if (!fits(rule, text))
            return tl::unexpected(misfit(rule, text));
        return CheckedText(Fitting{std::string(text)});
    }
    /// Leaves out the characters that do not fit.
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
