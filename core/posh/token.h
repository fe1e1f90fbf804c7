// The words of a plan, with their places. Malformed ones are tokens as well, so that their errors come in turn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/posh/finding.h"
#include "core/posh/keyword.h"

namespace usar::posh {

enum class TokenKind : std::uint8_t {
    Open,
    Close,
    Comma,
    Predicate,
    String,
    Variable, ///< with its `$`
    Symbol,   ///< with its `'`
    Integer,
    Float,
    Name,
    Bad, ///< see TokenList::errors
    End, ///< one past the last character
};

struct Token {
    TokenKind kind = TokenKind::End;
    Keyword keyword = Keyword::None; ///< of a name
    bool first_on_line = false;
    Spot at;
};

/// What is wrong with a Bad token, and where: not always at its start.
struct LexicalError {
    Code code = Code::IllegalCharacter;
    Spot at;
};

/// A comment with its mark and without the line end; length 0 is one or more blank lines.
struct Comment {
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    bool whole_line = false; ///< nothing else stands before it on its line
};

struct TokenList {
    std::vector<Token> tokens;        ///< the last one is End
    std::vector<LexicalError> errors; ///< one for each Bad token, in their order
    std::vector<Comment> comments;    ///< in the order of the text
    Findings warnings;                ///< bad bytes, odd spaces, names that start with a digit
};

/// The longest text that is read; what is longer is no plan.
constexpr std::size_t longest_plan_bytes = std::size_t{64} << 20U;

/// `text` must not be longer than longest_plan_bytes.
TokenList tokenize(std::string_view text);

/// The bytes at a spot.
inline std::string_view textOf(std::string_view text, const Spot& at) {
    return text.substr(at.offset, at.length);
}

} // namespace usar::posh
