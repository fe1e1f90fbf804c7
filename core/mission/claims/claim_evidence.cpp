#include "core/mission/claims/claim_evidence.h"

namespace usar::mission {

namespace {

constexpr Seconds trace_piece{5.0}; ///< A piece of a plan's trace comes no later than this.

} // namespace

void ClaimEvidence::takeHeight(Seconds since, double height_m) {
    if (!isAboutHeight(claim_.kind) || !includes(since))
        return;
    seen_ = true;
    (holdsAt(height_m, claim_) ? met_ : missed_) = true;
}

void ClaimEvidence::takeState(Seconds since, const std::string& state) {
    if (claim_.kind != ClaimKind::State || !includes(since))
        return;
    seen_ = true;
    met_ = met_ || hasState(state, claim_);
}

void ClaimEvidence::takeRun(Seconds since, const std::string& element) {
    if (isAboutPlan(claim_.kind) && element == claim_.name && includes(since))
        met_ = true;
}

std::optional<bool> ClaimEvidence::held() const {
    switch (claim_.kind) {
    case ClaimKind::NoContact:
        return std::nullopt;
    case ClaimKind::AltitudeAbove:
    case ClaimKind::AltitudeBelow:
        return seen_ ? std::optional(!missed_) : std::nullopt;
    case ClaimKind::State:
        return seen_ ? std::optional(met_) : std::nullopt;
    case ClaimKind::ElementRuns:
        return met_;
    case ClaimKind::ElementRests:
        return !met_;
    }
    return std::nullopt;
}

Seconds knownAt(const Claim& claim) {
    return claim.to + (isAboutPlan(claim.kind) ? trace_piece : Seconds{0.0});
}

} // namespace usar::mission
