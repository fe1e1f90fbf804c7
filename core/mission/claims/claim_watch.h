// Watches a flight and judges claims about it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/published.h"
#include "core/mission/claims/claim_evidence.h"
#include "core/mission/claims/height_watch.h"
#include "core/mission/claims/plan_watch.h"
#include "core/mission/files/claim.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Counts the contacts of the robot so far; nullopt if nobody knows them.
using CountContacts = std::function<std::optional<int>()>;

/// Takes what the session takes, in its order. Times count from the start of the behavior, which its first status
/// tells. Contacts are asked for at the two times of a claim only. Reads no clock; belongs to one thread.
class ClaimWatch {
public:
    explicit ClaimWatch(std::vector<Claim> claims = {}, CountContacts count_contacts = {});

    /// Takes an info line; `now` is on the protocol clock.
    void take(const protocol::InfoLine& line, Seconds now);
    void take(const agent::Published& value);
    /// The flight is over: claims whose time is not over do not hold.
    void end();

    bool empty() const { return verdicts_.empty(); }
    /// True if each claim is judged, or one is broken. False without claims.
    bool decided() const;
    /// True if each claim is judged and holds. False without claims.
    bool allHold() const;
    /// One sentence on the result: that of the first claim that is broken, or that all hold.
    std::string sentence() const;
    const std::vector<ClaimVerdict>& verdicts() const { return verdicts_; }

private:
    /// What was seen for one claim within its time.
    struct Seen {
        ClaimEvidence evidence;
        std::optional<int> contacts_before{};
        bool began = false; ///< Its time has begun.
    };

    void takeStatus(const agent::BehaviorStatus& status);
    void takeRun(const std::string& element, Seconds time);
    void takeHeight(double height_m);
    bool isMet(std::size_t at) const;
    bool isBroken(std::size_t at) const;
    void look(std::size_t at);
    void close(std::size_t at);
    void judge(std::size_t at, bool holds, const std::string& why);

    std::vector<ClaimVerdict> verdicts_;
    std::vector<Seen> seen_; ///< Their indices are those of the verdicts.
    CountContacts count_contacts_;
    std::unique_ptr<PlanWatch> plan_; ///< null: no claim is about a plan
    HeightWatch height_;
    std::optional<Seconds> origin_; ///< The behavior started then, on the protocol clock.
    Seconds since_{0.0};            ///< Time since then.
};

} // namespace usar::mission
