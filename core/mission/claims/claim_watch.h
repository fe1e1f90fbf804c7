// Watches a flight, live or recorded, and judges claims about it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/published.h"
#include "core/mission/claims/plan_watch.h"
#include "core/mission/files/claim.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Counts the contacts of the robot so far; nullopt if nobody knows them.
using CountContacts = std::function<std::optional<int>()>;

/// Takes what the session takes, in its order. The altitude is that of ground truth if the robot reports it, else of
/// INS. Contacts are asked for at the two times of a claim only. Reads no clock; belongs to one thread.
class ClaimWatch {
public:
    explicit ClaimWatch(std::vector<Claim> claims = {}, CountContacts count_contacts = {});

    /// Takes an info line. `spawned_at` and `now` are on the protocol clock; 0: not known yet.
    void take(const protocol::InfoLine& line, Seconds spawned_at, Seconds now);
    void take(const agent::Published& value);
    /// The flight is over: claims whose time is not over do not hold.
    void end();

    bool empty() const { return verdicts_.empty(); }
    /// True if each claim is judged, or one is broken. False without claims.
    bool decided() const;
    /// True if each claim is judged and holds.
    bool allHold() const;
    /// One sentence on the result: that of the first claim that is broken, or that all hold.
    std::string sentence() const;
    const std::vector<ClaimVerdict>& verdicts() const { return verdicts_; }

private:
    /// What was seen for one claim within its time.
    struct Seen {
        std::optional<int> contacts_before{};
        bool began = false; ///< Its time has begun.
        bool pose = false;  ///< A pose was reported within its time.
        bool held = false;  ///< What must hold once has held.
    };

    /// Takes a height and that of the first pose from the same source, which it sets if there is none.
    void takeHeight(double z_m, std::optional<double>& first_z_m);
    void look(std::size_t at);
    void close(std::size_t at);
    void judge(std::size_t at, bool holds, const std::string& why);
    bool within(const Claim& claim) const { return since_ >= claim.from && since_ <= claim.to; }

    std::vector<ClaimVerdict> verdicts_;
    std::vector<Seen> seen_; ///< Their indices are those of the verdicts.
    CountContacts count_contacts_;
    PlanWatch plan_;
    Seconds spawned_at_{0.0};
    Seconds since_{0.0}; ///< Time since the robot appeared.
    bool truth_known_ = false;
    std::optional<double> first_ins_m_;
    std::optional<double> first_truth_m_;
};

} // namespace usar::mission
