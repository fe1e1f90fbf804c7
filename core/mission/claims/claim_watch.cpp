#include "core/mission/claims/claim_watch.h"

#include <algorithm>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::mission {

namespace {

/// The claim must hold all the time, and not only once.
bool mustLast(ClaimKind kind) {
    return kind != ClaimKind::State && kind != ClaimKind::ElementRuns;
}

bool isAboutPlan(ClaimKind kind) {
    return kind == ClaimKind::ElementRuns || kind == ClaimKind::ElementRests;
}

bool isAboutHeight(ClaimKind kind) {
    return kind == ClaimKind::AltitudeAbove || kind == ClaimKind::AltitudeBelow;
}

std::string at(Seconds time) {
    return " at " + fixed(time.count(), 1) + " s";
}

} // namespace

ClaimWatch::ClaimWatch(std::vector<Claim> claims, CountContacts count_contacts)
    : seen_(claims.size())
    , count_contacts_(std::move(count_contacts)) {
    for (Claim& claim : claims)
        verdicts_.push_back({.claim = std::move(claim)});
}

void ClaimWatch::take(const protocol::InfoLine& line, Seconds spawned_at, Seconds now) {
    if (empty() || spawned_at.count() == 0.0)
        return;
    spawned_at_ = spawned_at;
    since_ = now - spawned_at;
    if (const auto* const truth = std::get_if<protocol::GroundTruthReading>(&line.message)) {
        truth_known_ = true;
        takeHeight(truth->base_in_map.position_m.z(), first_truth_m_);
    } else if (const auto* const ins = std::get_if<protocol::InsReading>(&line.message); ins && !truth_known_) {
        takeHeight(ins->base_in_map.position_m.z(), first_ins_m_);
    }
    for (std::size_t i = 0; i < verdicts_.size(); ++i)
        if (!verdicts_[i].holds)
            look(i);
}

void ClaimWatch::take(const agent::Published& value) {
    if (empty())
        return;
    if (const auto* const status = std::get_if<agent::BehaviorStatus>(&value)) {
        for (std::size_t i = 0; i < verdicts_.size(); ++i)
            if (const Claim& claim = verdicts_[i].claim; claim.kind == ClaimKind::State && within(claim))
                seen_[i].held |= lowerCase(status->state).find(lowerCase(claim.name)) != std::string::npos;
    } else if (const auto* const trace = std::get_if<agent::PlanTrace>(&value)) {
        plan_.take(trace->bytes, [this](const std::string& name, Seconds time) {
            for (std::size_t i = 0; i < verdicts_.size(); ++i) {
                const Claim& claim = verdicts_[i].claim;
                const Seconds since = time - spawned_at_;
                if (isAboutPlan(claim.kind) && claim.name == name && since >= claim.from && since <= claim.to)
                    seen_[i].held = true;
            }
        });
    }
}

void ClaimWatch::takeHeight(double z_m, std::optional<double>& first_z_m) {
    if (!first_z_m)
        first_z_m = z_m;
    const double height_m = z_m - *first_z_m;
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
        const Claim& claim = verdicts_[i].claim;
        if (!isAboutHeight(claim.kind) || verdicts_[i].holds || !within(claim))
            continue;
        seen_[i].pose = true;
        const bool holds =
            claim.kind == ClaimKind::AltitudeAbove ? height_m > claim.height_m : height_m < claim.height_m;
        if (!holds)
            judge(i, false, "the altitude was " + fixed(height_m, 2) + " m" + at(since_));
    }
}

/// Opens the claim's time, and closes it when it is over. The trace of a plan comes in pieces, so a claim about a plan
/// waits a while for the last one.
void ClaimWatch::look(std::size_t i) {
    const Claim& claim = verdicts_[i].claim;
    constexpr Seconds piece{5.0};
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
        if (!contacts || !seen.contacts_before)
            judge(i, false, "contacts are not known here: only the embedded simulator tells them");
        else
            judge(i, *contacts == *seen.contacts_before,
                  std::to_string(*contacts - *seen.contacts_before) + " contacts were counted");
    } else if (isAboutHeight(claim.kind)) {
        judge(i, seen.pose, "the robot reported no pose within that time");
    } else if (claim.kind == ClaimKind::State) {
        judge(i, seen.held, "no such state was published");
    } else if (!plan_.has(claim.name)) {
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
        const bool over = since_ >= claim.to || (!mustLast(claim.kind) && seen_[i].held);
        if (over)
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
    return std::ranges::all_of(verdicts_, [](const ClaimVerdict& verdict) { return verdict.holds == true; });
}

std::string ClaimWatch::sentence() const {
    const auto broken = std::ranges::find(verdicts_, std::optional(false), &ClaimVerdict::holds);
    if (broken != verdicts_.end())
        return "The claim is broken: " + sentenceOf(broken->claim) + "; " + broken->why + ".";
    return verdicts_.size() == 1 ? "The claim holds: " + sentenceOf(verdicts_.front().claim) + "."
                                 : "All " + std::to_string(verdicts_.size()) + " claims hold.";
}

} // namespace usar::mission
