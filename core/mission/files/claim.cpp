#include "core/mission/files/claim.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/numbers.h"
#include "core/mission/files/json_reading.h"

namespace usar::mission {

namespace {

/// The word of a kind in files, and the key that says more about it; empty: none.
struct KindWord {
    ClaimKind kind;
    const char* word;
    const char* detail;
};
constexpr std::array kind_words{KindWord{ClaimKind::NoContact, "no contact", ""},
                                KindWord{ClaimKind::AltitudeAbove, "altitude above", "height_m"},
                                KindWord{ClaimKind::AltitudeBelow, "altitude below", "height_m"},
                                KindWord{ClaimKind::State, "state", "text"},
                                KindWord{ClaimKind::ElementRuns, "element runs", "element"},
                                KindWord{ClaimKind::ElementRests, "element rests", "element"}};
constexpr double longest_s = 1e9;

const KindWord& wordOf(ClaimKind kind) {
    return *std::ranges::find(kind_words, kind, &KindWord::kind);
}

bool isHeight(const KindWord& word) {
    return std::string_view(word.detail) == "height_m";
}

QString allWords() {
    QStringList words;
    for (const KindWord& word : kind_words)
        words << '"' + QString(word.word) + '"';
    return words.join(", ");
}

/// `path` is that of the object: "claims[0]".
Claim readClaim(JsonReading& reading, const QJsonObject& object, const QString& path) {
    std::string word;
    reading.text(object, path + ".claim", word, true);
    const auto known =
        std::ranges::find_if(kind_words, [&](const KindWord& candidate) { return word == candidate.word; });
    if (known == kind_words.end()) {
        reading.failAt(path + ".claim", '"' + QString::fromStdString(word) + "\" cannot be claimed",
                       "write one of " + allWords());
        return {};
    }
    Claim claim{.kind = known->kind};
    double from_s = 0.0, to_s = 0.0;
    reading.number(object, path + ".from_s", from_s, true, "seconds");
    reading.number(object, path + ".to_s", to_s, true, "seconds");
    if (!(from_s >= 0.0 && from_s < to_s && to_s <= longest_s))
        reading.failAt(path + ".to_s", "the times of the claim are no span after the robot has appeared",
                       "write from_s from 0 up, and to_s above it");
    claim.from = Seconds{from_s};
    claim.to = Seconds{to_s};
    if (isHeight(*known))
        reading.number(object, path + ".height_m", claim.height_m, true);
    else if (*known->detail)
        reading.text(object, path + '.' + known->detail, claim.name, true);
    return claim;
}

} // namespace

std::string wordsOf(const Claim& claim) {
    switch (claim.kind) {
    case ClaimKind::NoContact:
        break;
    case ClaimKind::AltitudeAbove:
    case ClaimKind::AltitudeBelow:
        return wordOf(claim.kind).word + (" " + fixed(claim.height_m, 2)) + " m";
    case ClaimKind::State:
        return "state \"" + claim.name + "\"";
    case ClaimKind::ElementRuns:
        return "plan element " + claim.name + " runs";
    case ClaimKind::ElementRests:
        return "plan element " + claim.name + " does not run";
    }
    return "no contact";
}

std::string sentenceOf(const Claim& claim) {
    return wordsOf(claim) + " from " + fixed(claim.from.count(), 1) + " s to " + fixed(claim.to.count(), 1) + " s";
}

const std::vector<std::string>& claimKeys() {
    static const std::vector<std::string> keys{"claim", "from_s", "to_s", "height_m", "text", "element"};
    return keys;
}

std::vector<Claim> readClaims(JsonReading& reading, const QJsonObject& root) {
    const QJsonValue value = root["claims"];
    if (value.isUndefined())
        return {};
    std::vector<Claim> claims;
    const QJsonArray list = value.toArray();
    const bool are_objects =
        value.isArray() && std::ranges::all_of(list, [](const QJsonValue one) { return one.isObject(); });
    if (!are_objects)
        reading.failAt("claims", "the claims are no list of objects",
                       "write for example [{\"claim\": \"no contact\", \"from_s\": 10, \"to_s\": 20}]");
    else
        for (int i = 0; i < list.size(); ++i)
            claims.push_back(readClaim(reading, list[i].toObject(), QString("claims[%1]").arg(i)));
    return claims;
}

QJsonArray claimsToJson(const std::vector<Claim>& claims) {
    QJsonArray list;
    for (const Claim& claim : claims) {
        const KindWord& word = wordOf(claim.kind);
        QJsonObject object{{"claim", word.word}, {"from_s", claim.from.count()}, {"to_s", claim.to.count()}};
        if (isHeight(word))
            object[word.detail] = claim.height_m;
        else if (*word.detail)
            object[word.detail] = QString::fromStdString(claim.name);
        list << object;
    }
    return list;
}

} // namespace usar::mission
