#include "core/mission/claims/claim_watch.h"

#include <algorithm>
#include <utility>

#include "core/base/numbers.h"

namespace usar::mission {

namespace {

constexpr Seconds piece{5.0}; ///< A piece of a plan's trace comes no later than this.

std::string at(Seconds time) {
    return " at " + fixed(time.count(), 1) + " s";
}

bool includes(const Claim& claim, Seconds since) {
    return since >= claim.from && since <= claim.to;
}

} // namespace

ClaimWatch::ClaimWatch(std::vector<Claim> claims, CountContacts count_contacts)
    : seen_(claims.size())
    , count_contacts_(std::move(count_contacts)) {
    for (Claim& claim : claims) {
        if (isAboutPlan(claim.kind) && !plan_)
            plan_ = std::make_unique<PlanWatch>();
        verdicts_.push_back({.claim = std::move(claim)});
    }
}

void ClaimWatch::take(const protocol::InfoLine& line, Seconds now) {
    if (empty() || !origin_)
        return;
    since_ = now - *origin_;
    if (const auto height_m = height_.take(line))
        takeHeight(*height_m);
    for (std::size_t i = 0; i < verdicts_.size(); ++i)
        if (!verdicts_[i].holds)
            look(i);
}

void ClaimWatch::take(const agent::Published& value) {
    if (empty())
        return;
    if (const auto* const status = std::get_if<agent::BehaviorStatus>(&value))
        takeStatus(*status);
    else if (const auto* const trace = std::get_if<agent::PlanTrace>(&value); trace && plan_)
        plan_->take(trace->bytes, [this](const std::string& element, Seconds time) { takeRun(element, time); });
}

void ClaimWatch::takeStatus(const agent::BehaviorStatus& status) {
    if (!origin_)
        origin_ = status.time - status.elapsed;
    for (std::size_t i = 0; i < verdicts_.size(); ++i)
        if (const Claim& claim = verdicts_[i].claim;
            claim.kind == ClaimKind::State && includes(claim, status.time - *origin_))
            seen_[i].held |= hasState(status.state, claim);
}

void ClaimWatch::takeRun(const std::string& element, Seconds time) {
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
        const Claim& claim = verdicts_[i].claim;
        if (!isAboutPlan(claim.kind) || claim.name != element || !origin_ || !includes(claim, time - *origin_))
            continue;
        seen_[i].held = true;
        if (claim.kind == ClaimKind::ElementRests)
            judge(i, false, "it ran" + at(time - *origin_));
    }
}

void ClaimWatch::takeHeight(double height_m) {
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
        const Claim& claim = verdicts_[i].claim;
        if (!isAboutHeight(claim.kind) || verdicts_[i].holds || !includes(claim, since_))
            continue;
        seen_[i].pose = true;
        if (!holdsAt(height_m, claim))
            judge(i, false, "the altitude was " + fixed(height_m, 2) + " m" + at(since_));
    }
}

/// Opens the claim's time, and closes it when it is over. The trace of a plan comes in pieces, so a claim about a plan
/// waits a while for the last one.
void ClaimWatch::look(std::size_t i) {
    const Claim& claim = verdicts_[i].claim;
    if (since_ >= claim.from && !std::exchange(seen_[i].began, true) && claim.kind == ClaimKind::NoContact &&
        count_contacts_)
        seen_[i].contacts_before = count_contacts_();
    if (!mustLast(claim.kind) && seen_[i].held)
        judge(i, true, {});
    else if (since_ > claim.to + (isAboutPlan(claim.kind) ? piece : Seconds{0.0}))
        close(i);
}

void ClaimWatch::close(std::size_t i) {
    const Claim& claim = verdicts_[i].claim;
    const Seen& seen = seen_[i];
    if (claim.kind == ClaimKind::NoContact) {
        const std::optional<int> contacts = count_contacts_ ? count_contacts_() : std::nullopt;
        const int more = contacts.value_or(0) - seen.contacts_before.value_or(0);
        if (!contacts || !seen.contacts_before)
            judge(i, false,
                  "nobody knows the contacts: only the embedded simulator counts them, while the robot is in it");
        else
            judge(i, more == 0,
                  more == 1 ? "one contact was counted" : std::to_string(more) + " contacts were counted");
    } else if (isAboutHeight(claim.kind)) {
        judge(i, seen.pose, "the robot reported no pose within that time");
    } else if (claim.kind == ClaimKind::State) {
        judge(i, seen.held, "no such state was published");
    } else if (!plan_->has(claim.name)) {
        judge(i, false, "no plan with such an element ran");
    } else {
        const bool runs = claim.kind == ClaimKind::ElementRuns;
        judge(i, seen.held == runs, runs ? "it did not run" : "it ran");
    }
}

void ClaimWatch::judge(std::size_t i, bool holds, const std::string& why) {
    verdicts_[i].holds = holds;
    verdicts_[i].why = holds ? std::string() : why;
}

void ClaimWatch::end() {
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
        if (verdicts_[i].holds)
            continue;
        const Claim& claim = verdicts_[i].claim;
        // The last piece of a plan's trace may be missing, so a claim about it needs more than its own time.
        const Seconds needed = claim.to + (isAboutPlan(claim.kind) ? piece : Seconds{0.0});
        if (since_ >= needed || (!mustLast(claim.kind) && seen_[i].held))
            close(i);
        else
            judge(i, false, "the flight ended" + at(since_) + ", before that time was over");
    }
}

bool ClaimWatch::decided() const {
    const auto broken = [](const ClaimVerdict& verdict) { return verdict.holds == false; };
    const auto open = [](const ClaimVerdict& verdict) { return !verdict.holds; };
    return !empty() && (std::ranges::any_of(verdicts_, broken) || std::ranges::none_of(verdicts_, open));
}

bool ClaimWatch::allHold() const {
    return !empty() &&
           std::ranges::all_of(verdicts_, [](const ClaimVerdict& verdict) { return verdict.holds == true; });
}

std::string ClaimWatch::sentence() const {
    const auto broken = std::ranges::find(verdicts_, std::optional(false), &ClaimVerdict::holds);
    if (broken != verdicts_.end())
        return "The claim is broken: " + sentenceOf(broken->claim) + "; " + broken->why + ".";
    return verdicts_.size() == 1 ? "The claim holds: " + sentenceOf(verdicts_.front().claim) + "."
                                 : "All " + std::to_string(verdicts_.size()) + " claims hold.";
}

} // namespace usar::mission
