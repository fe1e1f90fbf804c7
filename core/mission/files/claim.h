// Claims about a moment of a flight, as a mission file has them: what a test of the flight checks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>

#include "core/base/clock.h"

namespace usar::mission {

class JsonReading;

/// What is claimed. The first three hold if they hold all the time between the claim's two times, the others if they
/// hold at one moment at least, and ElementRests if its element never runs.
enum class ClaimKind {
    NoContact,     ///< The robot touches nothing; only an embedded simulator knows it.
    AltitudeAbove, ///< The robot is higher than `height_m`.
    AltitudeBelow, ///< The robot is lower than `height_m`.
    State,         ///< The state that the behavior publishes has the words of `name` in it.
    ElementRuns,   ///< The drive, element, competence or act `name` of the POSH plan runs.
    ElementRests,  ///< It does not run.
};

/// One claim. Times count from the robot's first message, on the protocol clock; 0 <= from < to.
struct Claim {
    ClaimKind kind = ClaimKind::NoContact;
    Seconds from{0.0};
    Seconds to{0.0};
    double height_m = 0.0; ///< It is above the place where the robot appeared, z up.
    std::string name{};
    bool operator==(const Claim&) const = default;
};

/// What became of a claim.
struct ClaimVerdict {
    Claim claim;
    std::optional<bool> holds{}; ///< It is absent while the claim's time is not over.
    std::string why{};           ///< It says in words what was seen; empty if the claim holds.
    bool operator==(const ClaimVerdict&) const = default;
};

/// The claim without its times, in words: "no contact", "altitude above 2.00 m", "plan element evade runs".
std::string wordsOf(const Claim& claim);
/// The claim with its times: "no contact from 312.4 s to 322.4 s".
std::string sentenceOf(const Claim& claim);

/// Reads the key "claims" of a mission file, a list of objects {claim, from_s, to_s} with height_m for altitudes, text
/// for a state, and element for elements of a plan. Errors are kept in `reading`.
std::vector<Claim> readClaims(JsonReading& reading, const QJsonObject& root);
/// Names of the keys that an object of the list may have.
const std::vector<std::string>& claimKeys();
/// Returns what `readClaims` reads back.
QJsonArray claimsToJson(const std::vector<Claim>& claims);

} // namespace usar::mission
