#include "core/mission/claims/claim_watch.h"

#include <algorithm>
#include <utility>

#include "core/base/numbers.h"

namespace usar::mission {

namespace {

std::string at(Seconds time) {
    return " at " + fixed(time.count(), 1) + " s";
}

} // namespace

ClaimWatch::ClaimWatch(std::vector<Claim> claims, CountContacts count_contacts)
    : count_contacts_(std::move(count_contacts)) {
    for (Claim& claim : claims) {
        seen_.push_back({ClaimEvidence(claim)});
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
    for (Seen& seen : seen_)
        seen.evidence.takeState(status.time - *origin_, status.state);
}

void ClaimWatch::takeRun(const std::string& element, Seconds time) {
    for (std::size_t i = 0; origin_ && i < verdicts_.size(); ++i) {
        const bool was_broken = isBroken(i);
        seen_[i].evidence.takeRun(time - *origin_, element);
        if (!was_broken && isBroken(i))
            judge(i, false, "it ran" + at(time - *origin_));
    }
}

void ClaimWatch::takeHeight(double height_m) {
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
        const bool was_broken = isBroken(i);
        seen_[i].evidence.takeHeight(since_, height_m);
        if (!was_broken && isBroken(i))
            judge(i, false, "the altitude was " + fixed(height_m, 2) + " m" + at(since_));
    }
}

/// True if the claim must hold once, and has.
bool ClaimWatch::isMet(std::size_t i) const {
    return !mustLast(verdicts_[i].claim.kind) && seen_[i].evidence.held() == true;
}

/// True if the claim must hold all its time, and did not at one moment of it.
bool ClaimWatch::isBroken(std::size_t i) const {
    return mustLast(verdicts_[i].claim.kind) && seen_[i].evidence.held() == false;
}

/// Opens the claim's time, and closes it when enough is known.
void ClaimWatch::look(std::size_t i) {
    const Claim& claim = verdicts_[i].claim;
    if (since_ >= claim.from && !std::exchange(seen_[i].began, true) && claim.kind == ClaimKind::NoContact &&
        count_contacts_)
        seen_[i].contacts_before = count_contacts_();
    if (isMet(i))
        judge(i, true, {});
    else if (since_ > knownAt(claim))
        close(i);
}

void ClaimWatch::close(std::size_t i) {
    const Claim& claim = verdicts_[i].claim;
    const Seen& seen = seen_[i];
    const std::optional<bool> held = seen.evidence.held();
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
        judge(i, held == true, "the robot reported no pose within that time");
    } else if (claim.kind == ClaimKind::State) {
        judge(i, held == true, held ? "no such state was published" : "no state was published within that time");
    } else if (!plan_->has(claim.name)) {
        judge(i, false, "no plan with such an element ran");
    } else {
        judge(i, held == true, claim.kind == ClaimKind::ElementRuns ? "it did not run" : "it ran");
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
        if (since_ >= knownAt(verdicts_[i].claim) || isMet(i))
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
