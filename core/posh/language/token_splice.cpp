#include "core/posh/language/token_splice.h"

#include <algorithm>
#include <span>

#include "core/base/text.h"
#include "core/posh/model/keyword.h"

namespace usar::posh {

namespace {

/// Returns whether two tokens mean the same. Keywords may differ in case.
bool same(std::string_view a_text, const Token& a, std::string_view b_text, const Token& b) {
    const std::string_view a_word = textOf(a_text, a.at);
    const std::string_view b_word = textOf(b_text, b.at);
    if (a.kind != b.kind)
        return false;
    return a_word == b_word ||
           (a.kind == TokenKind::Name && keywordOf(a_word) != Keyword::None && sameWord(a_word, b_word));
}

std::span<const Token> tokensWithin(const TokenList& tokens, std::size_t begin, std::size_t end) {
    const auto before = [](const Token& token, std::size_t offset) { return token.at.offset < offset; };
    const auto first = std::lower_bound(tokens.tokens.begin(), tokens.tokens.end() - 1, begin, before);
    const auto last = std::lower_bound(first, tokens.tokens.end() - 1, end, before);
    return {first, last};
}

bool hasCommentWithin(const TokenList& tokens, std::size_t begin, std::size_t end) {
    auto at = std::lower_bound(tokens.comments.begin(), tokens.comments.end(), begin,
                               [](const Comment& comment, std::size_t offset) { return comment.offset < offset; });
    while (at != tokens.comments.end() && at->offset < end && at->length == 0)
        ++at; // Skip blank lines
    return at != tokens.comments.end() && at->offset < end;
}

bool isWord(const Token& token) {
    return token.kind > TokenKind::Comma;
}

} // namespace

std::optional<Splice> spliceTokens(std::string_view text, const TokenList& tokens, std::size_t begin, std::size_t end,
                                   std::string_view wanted) {
    const TokenList wanted_tokens = tokenize(wanted);
    const std::span<const Token> old = tokensWithin(tokens, begin, end);
    const std::span<const Token> all(wanted_tokens.tokens.data(), wanted_tokens.tokens.size() - 1);
    const std::size_t shorter = std::min(old.size(), all.size());
    std::size_t front = 0;
    while (front < shorter && same(text, old[front], wanted, all[front]))
        ++front;
    std::size_t back = 0;
    while (back < shorter - front && same(text, old[old.size() - 1 - back], wanted, all[all.size() - 1 - back]))
        ++back;
    if (front == 0 || back == 0)
        return std::nullopt; // Not even the outer parentheses agree
    std::size_t old_end = old.size() - back;
    std::size_t new_end = all.size() - back;
    const bool inserts_end_of_list = front == old_end && front > 1 && front < new_end &&
                                     old[front - 1].kind == TokenKind::Open && all[new_end - 1].kind == TokenKind::Open;
    if (inserts_end_of_list) { // Insert a whole list before the existing one, not inside its parenthesis
        --front;
        --old_end;
        --new_end;
    }
    const bool replaces = front < old_end && front < new_end;
    Splice splice;
    splice.begin = replaces ? old[front].at.offset : old[front - 1].at.end();
    splice.end = front < old_end ? old[old_end - 1].at.end() : splice.begin;
    if (front < new_end) {
        const std::size_t from = replaces ? all[front].at.offset : all[front - 1].at.end();
        splice.text = wanted.substr(from, all[new_end - 1].at.end() - from);
    }
    const Token& before_rest = front < new_end ? all[new_end - 1] : old[front - 1];
    if (!replaces && splice.end == old[old_end].at.offset && isWord(old[old_end]) && isWord(before_rest))
        splice.text += ' '; // Otherwise two words would become one
    if (hasCommentWithin(tokens, splice.begin, splice.end))
        return std::nullopt;
    return splice;
}

std::string spliced(std::string_view text, std::size_t begin, std::size_t end, const std::vector<Splice>& splices) {
    std::string result;
    for (const Splice& splice : splices) {
        if (splice.begin < begin || splice.end > end)
            continue;
        result += text.substr(begin, splice.begin - begin);
        result += splice.text;
        begin = splice.end;
    }
    result += text.substr(begin, end - begin);
    return result;
}

} // namespace usar::posh
