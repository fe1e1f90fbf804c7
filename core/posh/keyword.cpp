#include "core/posh/keyword.h"

#include <initializer_list>

#include "core/base/text.h"

namespace usar::posh {

namespace {

struct KeywordName {
    std::string_view word;
    Keyword keyword;
};

Keyword among(std::string_view word, std::initializer_list<KeywordName> entries) {
    const char first = lowerCase(word.front()); // most names are told by it
    for (const KeywordName& entry : entries)
        if (first == lowerCase(entry.word.front()) && sameWord(word, entry.word))
            return entry.keyword;
    return Keyword::None;
}

} // namespace

Keyword keywordOf(std::string_view word) {
    using enum Keyword;
    switch (word.size()) { // nearly every word is a name: ask as little as possible
    case 1:
        return word == "C" || word == "c" ? C : None;
    case 2:
        return among(word, {{"AP", Ap}, {"AD", Ad}, {"DC", Dc}, {"hz", Hz}, {"pm", PerMinute}});
    case 3:
        return among(word, {{"nil", Nil}, {"RDC", Rdc}, {"SDC", Sdc}});
    case 4:
        return among(word, {{"goal", Goal}, {"true", True}, {"vars", Vars}, {"none", NoUnit}, {"SRDC", Srdc}});
    case 5:
        return among(word, {{"false", False}, {"hours", Hours}, {"ticks", Ticks}});
    case 6:
        return among(word, {{"drives", Drives}});
    case 7:
        return among(word, {{"trigger", Trigger}, {"minutes", Minutes}, {"seconds", Seconds}});
    case 8:
        return among(word, {{"elements", Elements}});
    case 13:
        return among(word, {{"documentation", Documentation}});
    default:
        return None;
    }
}

std::optional<CollectionKind> collectionKind(Keyword keyword) {
    if (keyword < Keyword::Dc || keyword > Keyword::Srdc)
        return std::nullopt;
    return static_cast<CollectionKind>(static_cast<int>(keyword) - static_cast<int>(Keyword::Dc));
}

std::optional<Unit> unitOf(Keyword keyword) {
    if (keyword < Keyword::Hours)
        return std::nullopt;
    return static_cast<Unit>(static_cast<int>(keyword) - static_cast<int>(Keyword::Hours));
}

bool isTimeUnit(Unit unit) {
    return unit <= Unit::None;
}

} // namespace usar::posh
