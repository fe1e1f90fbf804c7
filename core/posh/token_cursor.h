// Goes through the words of a plan, one error at a time: knows which parentheses are open and words the complaints.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/posh/finding.h"
#include "core/posh/keyword.h"
#include "core/posh/token.h"

namespace usar::posh {

/// `text` and `tokens` must outlive it. Complaints return false, so that a reading function can return them.
class TokenCursor {
public:
    TokenCursor(std::string_view text, const TokenList& tokens)
        : text_(text)
        , list_(&tokens)
        , tokens_(tokens.tokens.data())
        , last_(tokens.tokens.size() - 1) {
        openers_.reserve(32);
    }

    const Token& peek() const { return tokens_[index_]; }
    /// The last token (End) for all that lies beyond it.
    const Token& peek(std::size_t ahead) const { return tokens_[index_ + ahead < last_ ? index_ + ahead : last_]; }
    bool at(TokenKind kind) const { return peek().kind == kind; }
    bool at(TokenKind kind, std::size_t ahead) const { return peek(ahead).kind == kind; }
    bool atNumber(std::size_t ahead = 0) const { return at(TokenKind::Integer, ahead) || at(TokenKind::Float, ahead); }
    std::string_view word(std::size_t ahead = 0) const { return textOf(text_, peek(ahead).at); }
    /// None for what is no name.
    Keyword keyword() const { return peek().keyword; }
    Keyword keyword(std::size_t ahead) const { return peek(ahead).keyword; }
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

    /// As if a parenthesis stood before the present token.
    void pretendOpen() { openers_.push_back(index_); }

    std::size_t index() const { return index_; }
    /// Goes on at a token that lies outside of every parenthesis opened after the first `depth`.
    void resumeAt(std::size_t index, std::size_t depth);
    std::size_t depth() const { return openers_.size(); }

    /// From the first byte of `begin` to the end of the token that was passed last.
    Spot spotSince(const Spot& begin) const;

    /// Takes one token of the kind, or says what was expected: "the ( of a drive".
    bool take(TokenKind kind, std::string_view expected, std::string_view mend) {
        if (!at(kind))
            return unexpected(expected, mend);
        advance();
        return true;
    }
    bool takeKeyword(Keyword keyword, std::string_view expected, std::string_view mend);

    /// E202 at the present token.
    bool unexpected(std::string_view expected, std::string_view mend);
    /// Any error at the present token. A token that is malformed is complained of as such, and where the text has ended
    /// that is the error, whatever was expected.
    bool fail(Code code, std::string message);
    bool failAt(Code code, const Spot& at, std::string message);
    void warn(Code code, const Spot& at, std::string message);

    Findings takeFindings() { return std::move(findings_); }

private:
    std::string_view text_;
    const TokenList* list_;
    const Token* tokens_; ///< of the list
    std::size_t last_;    ///< of them
    std::size_t index_ = 0;
    std::size_t errors_passed_ = 0;    ///< Bad tokens before index_
    std::vector<std::size_t> openers_; ///< which tokens opened what is not closed yet
    Findings findings_;
};

} // namespace usar::posh
