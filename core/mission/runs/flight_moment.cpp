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
#include "core/mission/claims/plan_watch.h"
#include "core/mission/session/stream_name.h"
#include "core/modules/state.h"
#include "core/protocol/reader.h"

namespace usar::mission {

namespace {

/// Text of the fault in a sentence such as "60.2 s: fault begins: wind speed=5 from=60"; empty if none begins.
std::string faultIn(const std::string& sentence) {
    constexpr std::string_view begins = "fault begins: ";
    const auto found = sentence.find(begins);
    return found == std::string::npos ? std::string() : sentence.substr(found + begins.size());
}

/// The fault as a simulator makes it whose time began with the robot. Less than a second passes in a mission without a
/// window before the robot appears, and there the times stay as they are.
std::string shifted(const std::string& fault, Seconds spawned_at) {
    constexpr Seconds at_once{1.0};
    constexpr std::string_view key = " from=";
    const auto found = fault.find(key);
    if (found == std::string::npos || spawned_at < at_once)
        return fault;
    const auto begin = found + key.size();
    const auto end = std::min(fault.find(' ', begin), fault.size());
    const double from_s = readNumber(fault.substr(begin, end - begin)).value_or(0.0) - spawned_at.count();
    return fault.substr(0, found) + (from_s > 0.0 ? std::string(key) + fixed(from_s, 2) : std::string()) +
           fault.substr(end);
}

/// Plays a recording and keeps what belongs to the moment.
class MomentPlayer : private link::ReplayTaker {
public:
    MomentPlayer(std::unique_ptr<link::RecordingReader> recording, Seconds now, Seconds reach)
        : path_(QString::fromStdString(recording->path()))
        , wanted_(now)
        , reach_(reach)
        , replayer_(std::move(recording), *this) {}

    Result<FlightMoment> play();

private:
    void rewound() override {}
    void opened(std::string_view) override { beginConnection(); }
    void closed(std::string_view) override {}
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override;
    void note(const link::Record& record) override;
    void quiet(bool) override {}

    void beginConnection();
    void takePublished(const agent::Published& value);
    void takeHeight(double z_m);
    Seconds since(Seconds now) const { return now - spawned_at_; }
    bool near(Seconds now) const { return now >= wanted_ - reach_ && now <= wanted_ + reach_; }
    bool before() const { return state_->now() <= wanted_; }

    const QString path_;
    const Seconds wanted_;
    const Seconds reach_;
    QEventLoop loop_; ///< before the replayer, whose timer needs the event loop of this thread
    protocol::Reader reader_;
    std::optional<modules::StateModule> state_{std::in_place};
    Seconds spawned_at_{0.0};
    bool robot_heard_ = false;
    bool truth_known_ = false;
    std::optional<double> first_z_m_;
    std::vector<std::string> faults_;
    std::optional<std::string> mission_;
    PlanWatch plan_;
    FlightMoment moment_;
    link::Replayer replayer_;
};

void MomentPlayer::beginConnection() {
    state_.emplace();
    spawned_at_ = Seconds{0.0};
    robot_heard_ = false;
    truth_known_ = false;
    first_z_m_.reset();
    faults_.clear();
    moment_ = {};
}

Result<FlightMoment> MomentPlayer::play() {
    QObject::connect(&replayer_, &link::Replayer::ended, &loop_, &QEventLoop::quit, Qt::QueuedConnection);
    replayer_.setSpeed(std::numeric_limits<double>::infinity());
    replayer_.setPlaying(true);
    loop_.exec();
    const auto flown = mission_
                           ? readFlownMission(*mission_, path_)
                           : Result<FlownMission>(failure("no mission was flown at that moment", path_.toStdString(),
                                                          "Choose a moment after a behavior was started"));
    if (!flown)
        return tl::unexpected(flown.error());
    moment_.flown = *flown;
    std::vector<std::string>& faults = moment_.flown.mission.faults;
    faults.clear(); // Those that had begun are told below, those of the mission among them.
    for (const std::string& fault : faults_)
        faults.push_back(shifted(fault, spawned_at_));
    moment_.at = since(wanted_);
    moment_.first = std::max(Seconds{0.0}, since(wanted_ - reach_));
    moment_.last = std::min(since(state_->now()), since(wanted_ + reach_));
    return moment_;
}

void MomentPlayer::line(std::string_view text, LineNumber number) {
    reader_.continueAfter({number.value - 1});
    const protocol::InfoLine& line = reader_.read(text);
    state_->take(line);
    robot_heard_ = robot_heard_ || isRobotData(line.message);
    if (robot_heard_ && spawned_at_.count() == 0.0)
        spawned_at_ = state_->now();
    if (const auto* const truth = std::get_if<protocol::GroundTruthReading>(&line.message)) {
        if (!std::exchange(truth_known_, true))
            first_z_m_.reset();
        takeHeight(truth->base_in_map.position_m.z());
    } else if (const auto* const ins = std::get_if<protocol::InsReading>(&line.message); ins && !truth_known_) {
        takeHeight(ins->base_in_map.position_m.z());
    }
    if (state_->now() > wanted_ + reach_)
        loop_.quit();
}

void MomentPlayer::takeHeight(double z_m) {
    if (!first_z_m_)
        first_z_m_ = z_m;
    if (near(state_->now()))
        moment_.heights_m.push_back({since(state_->now()), z_m - *first_z_m_});
}

void MomentPlayer::sent(const link::Record& record) {
    constexpr std::string_view drive = "DRIVE";
    const bool is_drive = sameWord(std::string_view(record.bytes).substr(0, drive.size()), drive);
    if (is_drive && before() && record.name.starts_with("by hand"))
        moment_.by_hand = true;
}

void MomentPlayer::note(const link::Record& record) {
    if (record.name == "mission" && before()) {
        mission_ = record.bytes;
        moment_.states.clear();
        moment_.by_hand = false;
    } else if (record.name == "fault") {
        if (std::string fault = faultIn(std::string(record.bytes)); !fault.empty())
            faults_.push_back(std::move(fault));
    } else if (record.name == "published") {
        if (const auto value = agent::readPublished(record.bytes))
            takePublished(*value);
    }
}

void MomentPlayer::takePublished(const agent::Published& value) {
    if (const auto* const status = std::get_if<agent::BehaviorStatus>(&value)) {
        const Seconds time = since(status->time);
        if (status->time > wanted_ + reach_)
            return;
        if (moment_.states.empty() || moment_.states.back().value != status->state)
            moment_.states.push_back({time, status->state});
    } else if (const auto* const trace = std::get_if<agent::PlanTrace>(&value)) {
        plan_.take(trace->bytes, [this](const std::string& name, Seconds time) {
            std::vector<Seconds>& runs = moment_.element_runs[name];
            if (near(time))
                runs.push_back(since(time));
        });
    }
}

/// Half meters, and at least 0.1 m away from what was flown.
double roundedDown(double height_m) {
    return std::floor((height_m - 0.1) * 2.0) / 2.0;
}

void offerHeights(const FlightMoment& moment, Claim claim, std::vector<ClaimOffer>& offers) {
    double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
    for (const auto& [time, height_m] : moment.heights_m)
        if (time >= claim.from && time <= claim.to) {
            least_m = std::min(least_m, height_m);
            most_m = std::max(most_m, height_m);
        }
    if (least_m > most_m)
        return;
    claim.kind = ClaimKind::AltitudeAbove;
    claim.height_m = roundedDown(least_m);
    offers.push_back({claim, true});
    claim.kind = ClaimKind::AltitudeBelow;
    claim.height_m = -roundedDown(-most_m);
    offers.push_back({claim, true});
}

} // namespace

Result<FlightMoment> readFlightMoment(const QString& path, Seconds now, Seconds reach) {
    auto recording = link::RecordingReader::open(path);
    if (!recording)
        return tl::unexpected(recording.error());
    return MomentPlayer(*std::move(recording), now, reach).play();
}

std::vector<ClaimOffer> claimsToOffer(const FlightMoment& moment, Seconds from, Seconds to) {
    const Claim about{.from = from, .to = to};
    std::vector<ClaimOffer> offers;
    offerHeights(moment, about, offers);
    for (std::size_t i = 0; i < moment.states.size(); ++i) {
        const bool over = i + 1 < moment.states.size() && moment.states[i + 1].time < from;
        const Claim claim{ClaimKind::State, from, to, 0.0, moment.states[i].value};
        const ClaimOffer offer{claim, true};
        if (!over && moment.states[i].time <= to && !claim.name.empty() &&
            std::ranges::find(offers, offer) == offers.end())
            offers.push_back(offer);
    }
    std::vector<ClaimOffer> resting;
    for (const auto& [name, times] : moment.element_runs) {
        const bool ran = std::ranges::any_of(times, [&](Seconds time) { return time >= from && time <= to; });
        (ran ? offers : resting)
            .push_back({{ran ? ClaimKind::ElementRuns : ClaimKind::ElementRests, from, to, 0.0, name}, true});
    }
    if (to > moment.last) // The rest of the time is not flown yet, or not recorded.
        for (ClaimOffer& offer : offers)
            if (offer.claim.kind != ClaimKind::State && offer.claim.kind != ClaimKind::ElementRuns)
                offer.held.reset();
    offers.push_back({about, std::nullopt});
    offers.insert(offers.end(), resting.begin(), resting.end());
    return offers;
}

Mission testOf(const FlightMoment& moment, const Claim& claim, const std::string& name) {
    Mission mission = moment.flown.mission;
    mission.name = name;
    mission.seed = moment.flown.seed;
    mission.claims = {claim};
    return mission;
}

} // namespace usar::mission
