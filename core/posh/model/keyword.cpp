#include "core/posh/model/keyword.h"

#include <array>
#include <cstdint>

#include "core/base/text.h"

namespace usar::posh {

namespace {

struct KeywordName {
    std::string_view word;
    Keyword keyword;
};

constexpr std::array keywords{
    KeywordName{"trigger", Keyword::Trigger}, // By far the most frequent keyword
    KeywordName{"goal", Keyword::Goal},
    KeywordName{"C", Keyword::C},
    KeywordName{"AP", Keyword::Ap},
    KeywordName{"AD", Keyword::Ad},
    KeywordName{"DC", Keyword::Dc},
    KeywordName{"RDC", Keyword::Rdc},
    KeywordName{"SDC", Keyword::Sdc},
    KeywordName{"SRDC", Keyword::Srdc},
    KeywordName{"documentation", Keyword::Documentation},
    KeywordName{"drives", Keyword::Drives},
    KeywordName{"elements", Keyword::Elements},
    KeywordName{"vars", Keyword::Vars},
    KeywordName{"nil", Keyword::Nil},
    KeywordName{"true", Keyword::True},
    KeywordName{"false", Keyword::False},
    KeywordName{"hours", Keyword::Hours},
    KeywordName{"minutes", Keyword::Minutes},
    KeywordName{"seconds", Keyword::Seconds},
    KeywordName{"none", Keyword::NoUnit},
    KeywordName{"hz", Keyword::Hz},
    KeywordName{"pm", Keyword::PerMinute},
    KeywordName{"ticks", Keyword::Ticks},
};

/// For each first character, a bit set of the lengths of the keywords that begin with it. It rules out nearly every
/// ordinary name without comparing it.
constexpr std::array<std::uint16_t, 256> lengthsByFirst() {
    std::array<std::uint16_t, 256> table{};
    for (const KeywordName& known : keywords) {
        const char first = lowerCase(known.word.front());
        const auto length = static_cast<std::uint16_t>(1U << known.word.size());
        table[static_cast<unsigned char>(first)] |= length;
        table[static_cast<unsigned char>(first - 'a' + 'A')] |= length;
    }
    return table;
}

constexpr std::array<std::uint16_t, 256> lengths = lengthsByFirst();

} // namespace

Keyword keywordOf(std::string_view word) {
    if (word.empty() || word.size() > 15 ||
        (lengths[static_cast<unsigned char>(word.front())] >> word.size() & 1U) == 0)
        return Keyword::None;
    for (const KeywordName& known : keywords)
        if (sameWord(word, known.word))
            return known.keyword;
    return Keyword::None;
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
