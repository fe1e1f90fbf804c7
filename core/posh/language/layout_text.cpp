#include "core/posh/language/layout_text.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/posh/language/token.h"

namespace usar::posh {

std::size_t lineRest(std::string_view text, std::size_t from) {
    std::size_t at = from;
    while (at < text.size() && text[at] != '\n' && isSpace(text[at]))
        ++at;
    if (at < text.size() && (text[at] == ';' || text[at] == '#'))
        at = std::min(text.find('\n', at), text.size());
    return at < text.size() && text[at] == '\n' ? at + 1 : from;
}

std::string withLineEnds(std::string_view text, std::string words) {
    if (text.find("\r\n") == std::string_view::npos)
        return words;
    const TokenList list = tokenize(words);
    std::string result;
    std::size_t done = 0;
    const auto copyTo = [&](std::size_t end, bool converts) {
        for (; done < end; ++done) {
            if (words[done] == '\n' && converts)
                result += '\r';
            result += words[done];
        }
    };
    for (const Token& token : list.tokens) {
        copyTo(token.at.offset, true);
        copyTo(token.at.offset + token.at.length, token.kind != TokenKind::String);
    }
    return result;
}

} // namespace usar::posh
