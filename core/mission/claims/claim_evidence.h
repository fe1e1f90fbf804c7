// Collects what was seen of a claim within its time, and tells whether the claim held by that.
#pragma once

#include <optional>
#include <string>

#include "core/mission/files/claim.h"

namespace usar::mission {

/// Who watches a flight and who looks at a recorded moment both judge by this, so their words are the same. Times count
/// from the start of the behavior; what was seen outside of the claim's time changes nothing. Knows nothing of
/// contacts. A plain value.
class ClaimEvidence {
public:
    explicit ClaimEvidence(Claim claim) : claim_(std::move(claim)) {}

    void takeHeight(Seconds since, double height_m);
    /// Takes what the behavior publishes, which it does at each tick: while nothing is published, there is no state.
    void takeState(Seconds since, const std::string& state);
    void takeRun(Seconds since, const std::string& element);

    /// Whether the claim held in what was seen; nullopt if nothing was seen that tells, as while the robot is silent.
    /// That nothing of a plan ran tells, too.
    std::optional<bool> held() const;

private:
    bool includes(Seconds since) const { return since >= claim_.from && since <= claim_.to; }

    Claim claim_;
    bool seen_ = false;   ///< A height or a state came within its time.
    bool met_ = false;    ///< What is claimed has held at least once.
    bool missed_ = false; ///< It was not so once.
};

/// A flight must be known until then to tell that a claim held all its time, or at no moment of it: the trace of a plan
/// comes in pieces, the last of them so much later.
Seconds knownAt(const Claim& claim);

} // namespace usar::mission
