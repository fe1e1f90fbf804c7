// Moves through the tokens of a plan, keeps track of open parentheses and collects findings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/posh/language/token.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/keyword.h"

namespace usar::posh {

/// `text` and `tokens` must outlive the cursor. The functions that report an error return false, so that a reading
/// function can return their result.
class TokenCursor {
public:
    TokenCursor(std::string_view text, const TokenList& tokens)
        : text_(text)
        , list_(&tokens)
        , tokens_(tokens.tokens.data())
        , last_(tokens.tokens.size() - 1) {
        openers_.reserve(32);
    }

    /// The current token.
    const Token& peek() const { return tokens_[index_]; }
    /// Returns the token `ahead` tokens after the current one, or the last token (End) beyond it.
    const Token& peek(std::size_t ahead) const { return tokens_[index_ + ahead < last_ ? index_ + ahead : last_]; }
    bool at(TokenKind kind) const { return peek().kind == kind; }
    bool at(TokenKind kind, std::size_t ahead) const { return peek(ahead).kind == kind; }
    bool atNumber(std::size_t ahead = 0) const { return at(TokenKind::Integer, ahead) || at(TokenKind::Float, ahead); }
    std::string_view word(std::size_t ahead = 0) const { return textOf(text_, peek(ahead).at); }
    /// The keyword of the current token; Keyword::None if it is not a name or not a keyword.
    Keyword keyword() const { return peek().keyword; }
    Keyword keyword(std::size_t ahead) const { return peek(ahead).keyword; }
    /// Moves to the next token; stays at End.
    void advance() {
        const TokenKind kind = peek().kind;
        if (kind == TokenKind::End)
            return;
        if (kind == TokenKind::Open)
            openers_.push_back(index_);
        else if (kind == TokenKind::Close && !openers_.empty())
            openers_.pop_back();
        else if (kind == TokenKind::Bad)
            ++errors_passed_;
        ++index_;
    }

    /// Acts as if there were an opening parenthesis before the current token.
    void pretendOpen() { openers_.push_back(index_); }

    /// The index of the current token.
    std::size_t index() const { return index_; }
    /// Moves forward to a token after an error and treats all but the outermost `depth` parentheses as closed.
    void resumeAt(std::size_t index, std::size_t depth);
    /// The number of open parentheses.
    std::size_t depth() const { return openers_.size(); }

    /// Returns the spot from the first byte of `begin` to the end of the token before the current one.
    Spot spotSince(const Spot& begin) const;

    /// Takes one token of this kind, or reports that `expected` was expected ("the ( of a drive") and advises to write
    /// `mend`.
    bool take(TokenKind kind, std::string_view expected, std::string_view mend) {
        if (!at(kind))
            return unexpected(expected, mend);
        advance();
        return true;
    }
    bool takeKeyword(Keyword keyword, std::string_view expected, std::string_view mend);

    /// Reports E202 at the current token.
    bool unexpected(std::string_view expected, std::string_view mend);
    /// Reports an error at the current token. If that token is malformed, its own error is reported instead; at the end
    /// of the text, the error is E203 (at most once in a row).
    bool fail(Code code, std::string message);
    /// Reports an error or a warning at any place. Always returns false.
    bool report(Code code, const Spot& at, std::string message);

    /// Moves the findings out of the cursor, in the order in which they were reported.
    Findings takeFindings() { return std::move(findings_); }

private:
    std::string_view text_;
    const TokenList* list_;
    const Token* tokens_; ///< the tokens of the list
    std::size_t last_;    ///< index of the last token
    std::size_t index_ = 0;
    std::size_t errors_passed_ = 0;    ///< number of Bad tokens before index_
    std::vector<std::size_t> openers_; ///< indices of the parentheses that are open
    Findings findings_;
};

} // namespace usar::posh
