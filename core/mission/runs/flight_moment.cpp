#include "core/mission/runs/flight_moment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QEventLoop>

#include "core/agent/published_text.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/link/replay.h"
#include "core/mission/claims/claim_evidence.h"
#include "core/mission/claims/height_watch.h"
#include "core/mission/claims/plan_watch.h"
#include "core/mission/files/fault_note.h"
#include "core/mission/session/stream_name.h"
#include "core/modules/state.h"
#include "core/protocol/reader.h"

namespace usar::mission {

namespace {

constexpr Seconds at_once{1.0}; ///< Without a window, less than this passes before the behavior starts.
constexpr std::string_view from_key = " from=";

/// A fault that was made to happen, as its sentences tell it; times are those of the simulation.
struct MadeFault {
    std::string text;
    Seconds begun{0.0};
    std::optional<Seconds> ended{};
};

/// The number after the key in a fault's text.
std::optional<double> numberOf(const std::string& fault, std::string_view key) {
    const auto found = fault.find(key);
    if (found == std::string::npos)
        return std::nullopt;
    const auto begin = found + key.size();
    return readNumber(fault.substr(begin, fault.find(' ', begin) - begin));
}

/// The text without this key and its value.
std::string without(std::string_view key, std::string fault) {
    if (const auto found = fault.find(key); found != std::string::npos)
        fault.erase(found, fault.find(' ', found + key.size()) - found);
    return fault;
}

void takeFault(const std::string& sentence, std::vector<MadeFault>& faults) {
    const auto note = readFaultNote(sentence);
    if (!note)
        return;
    if (note->begins) {
        faults.push_back({note->fault, note->time});
        return;
    }
    const auto same =
        std::ranges::find_if(faults, [&](const MadeFault& one) { return one.text == note->fault && !one.ended; });
    if (same != faults.end())
        same->ended = note->time;
}

/// The fault as a simulator makes it whose time begins with the behavior.
std::string shifted(const MadeFault& fault, Seconds origin) {
    std::string text = without(" robot=", fault.text); // A test has one robot.
    if (origin >= at_once) {
        const Seconds from = fault.begun - origin;
        text = without(from_key, text) + (from.count() > 0.0 ? std::string(from_key) + fixed(from.count(), 2) : "");
    }
    if (fault.ended && text.find(" for=") == std::string::npos)
        text += " for=" + fixed((*fault.ended - fault.begun).count(), 2);
    return text;
}

/// Plays a recording and keeps what belongs to the moment.
class MomentPlayer : private link::ReplayTaker {
public:
    MomentPlayer(std::unique_ptr<link::RecordingReader> recording, Seconds now, const std::atomic_bool& given_up,
                 Seconds reach)
        : path_(QString::fromStdString(recording->path()))
        , robot_name_(nameIn(recording->survey().facts))
        , wanted_(now)
        , reach_(reach)
        , given_up_(given_up)
        , replayer_(std::move(recording), *this) {}

    Result<FlightMoment> play();

private:
    static std::string nameIn(const std::map<std::string, std::string>& facts) {
        const auto found = facts.find("robot");
        return found == facts.end() ? std::string() : found->second;
    }

    void rewound() override {}
    void opened(std::string_view) override { beginConnection(); }
    void closed(std::string_view) override {}
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override;
    void note(const link::Record& record) override;
    void quiet(bool) override {}

    void stop();
    void beginConnection();
    void beginMission(std::string_view note);
    void takePublished(const agent::Published& value);
    void takeStatus(const agent::BehaviorStatus& status);
    FlightMoment result(FlownMission flown);
    std::vector<std::string> faultsOf(const Mission& mission) const;
    Seconds since(Seconds now) const { return now - origin_.value_or(now); }
    bool near(Seconds now) const { return now >= wanted_ - reach_ && now <= wanted_ + reach_; }
    bool before() const { return state_->now() <= wanted_; }

    const QString path_;
    const std::string robot_name_;
    const Seconds wanted_;
    const Seconds reach_;
    const std::atomic_bool& given_up_;
    QEventLoop loop_;   ///< before the replayer, whose timer needs the event loop of this thread
    bool done_ = false; ///< What is still played is not looked at.
    protocol::Reader reader_;
    std::optional<modules::StateModule> state_{std::in_place};
    std::optional<Seconds> heard_at_; ///< The robot's first message came then.
    std::optional<Seconds> origin_;   ///< The behavior started then.
    HeightWatch height_;
    std::vector<MadeFault> faults_;
    std::optional<std::string> mission_;
    PlanWatch plan_;
    FlightMoment moment_;
    link::Replayer replayer_;
};

void MomentPlayer::stop() {
    done_ = true;
    loop_.quit();
}

/// A connection or a mission after the moment ends what can be told about it.
void MomentPlayer::beginConnection() {
    if (!before())
        return stop();
    state_.emplace();
    heard_at_.reset();
    faults_.clear();
    mission_.reset();
    moment_ = {};
}

void MomentPlayer::beginMission(std::string_view note) {
    if (!before())
        return stop();
    mission_ = note;
    origin_.reset();
    height_ = {};
    plan_.clear();
    const bool by_hand = moment_.by_hand;
    moment_ = {};
    moment_.by_hand = by_hand;
}

Result<FlightMoment> MomentPlayer::play() {
    QObject::connect(&replayer_, &link::Replayer::ended, &loop_, &QEventLoop::quit, Qt::QueuedConnection);
    replayer_.setSpeed(std::numeric_limits<double>::infinity());
    replayer_.setPlaying(true);
    loop_.exec();
    if (given_up_)
        return failure("the recording is not wanted any longer", path_.toStdString());
    if (!mission_ || !origin_)
        return failure("no mission was flown at that moment", path_.toStdString(),
                       "Choose a moment after a behavior was started");
    auto flown = readFlownMission(*mission_, path_);
    if (!flown)
        return tl::unexpected(flown.error());
    return result(*std::move(flown));
}

FlightMoment MomentPlayer::result(FlownMission flown) {
    moment_.flown = std::move(flown);
    moment_.flown.mission.faults = faultsOf(moment_.flown.mission);
    moment_.at = since(wanted_);
    moment_.first = std::max(Seconds{0.0}, since(wanted_ - reach_));
    moment_.last = std::min(since(state_->now()), since(wanted_ + reach_));
    moment_.late = heard_at_ && *origin_ - *heard_at_ >= at_once;
    return std::move(moment_);
}

/// Those that had begun, and those of the mission that were still to come.
std::vector<std::string> MomentPlayer::faultsOf(const Mission& mission) const {
    std::vector<std::string> faults;
    for (const MadeFault& fault : faults_)
        if (fault.text.find(" robot=") == std::string::npos ||
            fault.text.find(" robot=" + robot_name_) != std::string::npos)
            faults.push_back(shifted(fault, *origin_));
    for (const std::string& fault : mission.faults)
        if (numberOf(fault, from_key).value_or(0.0) > since(state_->now()).count())
            faults.push_back(fault);
    return faults;
}

void MomentPlayer::line(std::string_view text, LineNumber number) {
    if (done_ || given_up_)
        return stop();
    reader_.continueAfter({number.value - 1});
    const protocol::InfoLine& line = reader_.read(text);
    state_->take(line);
    if (!heard_at_ && isRobotData(line.message) && state_->now().count() > 0.0)
        heard_at_ = state_->now();
    const auto height_m = origin_ ? height_.take(line) : std::nullopt;
    if (height_m && near(state_->now()))
        moment_.heights_m.push_back({since(state_->now()), *height_m});
    if (state_->now() > wanted_ + reach_)
        stop();
}

void MomentPlayer::sent(const link::Record& record) {
    constexpr std::string_view drive = "DRIVE";
    const bool is_drive = sameWord(std::string_view(record.bytes).substr(0, drive.size()), drive);
    if (is_drive && before() && record.name.starts_with("by hand"))
        moment_.by_hand = true;
}

void MomentPlayer::note(const link::Record& record) {
    if (done_)
        return;
    if (record.name == "mission")
        beginMission(record.bytes);
    else if (record.name == "fault")
        takeFault(std::string(record.bytes), faults_);
    else if (const auto value = record.name == "published" ? agent::readPublished(record.bytes) : std::nullopt)
        takePublished(*value);
}

void MomentPlayer::takePublished(const agent::Published& value) {
    if (const auto* const status = std::get_if<agent::BehaviorStatus>(&value))
        takeStatus(*status);
    else if (const auto* const trace = std::get_if<agent::PlanTrace>(&value))
        plan_.take(trace->bytes, [this](const std::string& name, Seconds time) {
            std::vector<Seconds>& runs = moment_.element_runs[name];
            if (near(time))
                runs.push_back(since(time));
        });
}

void MomentPlayer::takeStatus(const agent::BehaviorStatus& status) {
    if (!origin_)
        origin_ = status.time - status.elapsed;
    std::vector<ToldAt<std::string>>& states = moment_.states;
    const bool is_new = states.empty() || states.back().time < since(status.time); // A part of a recording repeats one.
    if (is_new && near(status.time))
        states.push_back({since(status.time), status.state});
}

/// Half a meter or more below, which is never less than 0.1 m; of a flight that is repeated roughly a meter more.
double roundedDown(double height_m, bool roughly) {
    return std::floor((height_m - (roughly ? 1.1 : 0.1)) * 2.0) / 2.0;
}

/// The claim with the time that it needs to be seen in a test as well.
Claim widened(Claim claim, bool roughly) {
    if (roughly && !mustLast(claim.kind)) {
        claim.from = std::max(Seconds{0.0}, claim.from - rough_slack);
        claim.to += rough_slack;
    }
    return claim;
}

void offerHeights(const FlightMoment& moment, Claim claim, std::vector<Claim>& offers) {
    double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
    for (const auto& [time, height_m] : moment.heights_m)
        if (time >= claim.from && time <= claim.to) {
            least_m = std::min(least_m, height_m);
            most_m = std::max(most_m, height_m);
        }
    const bool known = least_m <= most_m, roughly = isRepeatedRoughly(moment);
    claim.kind = ClaimKind::AltitudeAbove;
    claim.height_m = known ? roundedDown(least_m, roughly) : 2.0;
    offers.push_back(claim);
    claim.kind = ClaimKind::AltitudeBelow;
    claim.height_m = known ? -roundedDown(-most_m, roughly) : 20.0;
    offers.push_back(claim);
}

/// Returns what was recorded within the claim's time.
ClaimEvidence evidenceOf(const FlightMoment& moment, const Claim& claim) {
    ClaimEvidence evidence(claim);
    for (const auto& [time, height_m] : moment.heights_m)
        evidence.takeHeight(time, height_m);
    for (const auto& [time, state] : moment.states)
        evidence.takeState(time, state);
    if (const auto runs = moment.element_runs.find(claim.name); runs != moment.element_runs.end())
        for (const Seconds time : runs->second)
            evidence.takeRun(time, claim.name);
    return evidence;
}

} // namespace

Result<FlightMoment> readFlightMoment(const QString& path, Seconds now, const std::atomic_bool& given_up,
                                      Seconds reach) {
    auto recording = link::RecordingReader::open(path);
    if (!recording)
        return tl::unexpected(recording.error());
    return MomentPlayer(*std::move(recording), now, given_up, reach).play();
}

std::optional<bool> heldIn(const FlightMoment& moment, const Claim& claim) {
    if (claim.kind == ClaimKind::NoContact)
        return std::nullopt;
    const std::optional<bool> held = evidenceOf(moment, claim).held();
    const bool decided = held == !mustLast(claim.kind); // What comes later does not change it.
    const bool whole = claim.from >= moment.first && knownAt(claim) <= moment.last;
    return decided || whole ? held : std::nullopt;
}

bool isRepeatedRoughly(const FlightMoment& moment) {
    return moment.late || !moment.flown.seed;
}

std::vector<Claim> claimsToOffer(const FlightMoment& moment, Seconds from, Seconds to) {
    const Claim about{.from = from, .to = to};
    const bool roughly = isRepeatedRoughly(moment);
    std::vector<Claim> offers{about};
    offerHeights(moment, about, offers);
    for (const auto& [time, state] : moment.states) {
        const Claim offer = widened({ClaimKind::State, from, to, 0.0, state}, roughly);
        if (!state.empty() && time >= from && time <= to && std::ranges::find(offers, offer) == offers.end())
            offers.push_back(offer);
    }
    for (const auto& [name, times] : moment.element_runs)
        for (const ClaimKind kind : {ClaimKind::ElementRuns, ClaimKind::ElementRests})
            offers.push_back(widened({kind, from, to, 0.0, name}, roughly));
    std::ranges::stable_sort(offers, {}, [&](const Claim& claim) {
        const auto held = heldIn(moment, claim);
        if (roughly && claim.kind == ClaimKind::NoContact)
            return 0;
        return held == true ? 0 : held ? 2 : 1;
    });
    return offers;
}

Mission testOf(const FlightMoment& moment, const Claim& claim, const std::string& name) {
    constexpr std::uint64_t largest_typed = std::numeric_limits<std::int64_t>::max();
    Mission mission = moment.flown.mission;
    mission.name = name;
    mission.seed = moment.flown.seed;
    if (mission.seed && *mission.seed > largest_typed)
        mission.seed.reset(); // No command line can name it.
    mission.claims = {claim};
    return mission;
}

} // namespace usar::mission
