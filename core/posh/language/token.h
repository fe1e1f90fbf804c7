// The tokens of a plan's text, with their places. Malformed words are tokens, too, so that all errors are reported in
// order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/posh/model/finding.h"
#include "core/posh/model/keyword.h"

namespace usar::posh {

/// The kinds of tokens; white space and comments are none.
enum class TokenKind : std::uint8_t {
    Open,
    Close,
    Comma,
    Predicate,
    String,
    Variable, ///< including the `$`
    Symbol,   ///< including the `'`
    Integer,
    Float,
    Name,
    Bad, ///< malformed, see TokenList::errors
    End, ///< has no characters; its place is after the last character of the text
};

/// One token; its text is what `at` covers.
struct Token {
    TokenKind kind = TokenKind::End;
    Keyword keyword = Keyword::None; ///< set for names only
    bool first_on_line = false;
    Spot at;
};

/// The error of a Bad token. Its place is not always the start of the token.
struct LexicalError {
    Code code = Code::IllegalCharacter;
    Spot at;
};

/// A comment including its mark and without the line end. If the length is 0, it stands for one or more blank lines.
struct Comment {
    std::uint32_t offset = 0; ///< in bytes, like the length
    std::uint32_t length = 0;
    bool whole_line = false; ///< no token precedes it on its line
};

/// The result of tokenize.
struct TokenList {
    std::vector<Token> tokens;        ///< never empty; the last one is End
    std::vector<LexicalError> errors; ///< one for each Bad token, in their order
    std::vector<Comment> comments;    ///< in the order of the text
    Findings warnings;                ///< bytes that are not UTF-8, odd spaces, names that start with a digit
};

/// The length limit of a plan, 64 MiB; longer texts are rejected.
constexpr std::size_t longest_plan_bytes = std::size_t{64} << 20U;

/// Splits a text into tokens. Accepts any bytes; `text` must not be longer than longest_plan_bytes.
TokenList tokenize(std::string_view text);

/// Returns the bytes at a spot of the text.
inline std::string_view textOf(std::string_view text, const Spot& at) {
    return text.substr(at.offset, at.length);
}

/// The kind of a word.
struct WordKind {
    TokenKind kind = TokenKind::Name;
    bool starts_with_digit = false;           ///< it is a name, but starts with a digit
    std::optional<Code> error = std::nullopt; ///< set exactly if the kind is Bad
    std::size_t bad = 0;                      ///< byte offset of the error in the word
};

/// Classifies a word that is not quoted and does not include a leading `$` or `'`. The result is Integer, Float, Name
/// or Bad.
WordKind classifyWord(std::string_view word);

/// Classifies the word after a `'`: a name, or an enumeration constant if it has dots. The result is Symbol or Bad.
WordKind classifySymbol(std::string_view word);

} // namespace usar::posh
