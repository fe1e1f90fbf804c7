#include "hop.h"

#include <algorithm>
#include <array>

namespace usar::sample {

namespace {

constexpr double climb_m_s = 0.5;
constexpr double sink_m_s = -0.4;
constexpr double forward_m_s = 1.0;
/// The robot is on the ground if it has not sunk for this long, although commanded to.
constexpr Seconds on_the_ground{1.0};
constexpr double still_m = 0.02;

} // namespace

std::vector<agent::ParameterSpec> hopParameters() {
    return {{.id = "height_m",
             .label = "Height",
             .group = "Flight",
             .unit = "m",
             .default_value = 3.0,
             .minimum = 1.0,
             .maximum = 20.0,
             .help = "How far it climbs above its start.",
             .choices = {}},
            {.id = "distance_m",
             .label = "Distance",
             .group = "Flight",
             .unit = "m",
             .default_value = 5.0,
             .minimum = 0.0,
             .maximum = 50.0,
             .help = "How far it flies forward before it lands.",
             .choices = {}}};
}

/// Called with every STA message of the robot, several times per second of the robot's time. Look at the newest
/// readings, decide, and answer immediately; a slow answer would hold up the robot.
void Hop::tick(const agent::Tick& tick, agent::CommandPort& port) {
    const auto* const ins = tick.robot.sensors.ins();
    if (!ins || state_ == State::Done)
        return; // No reading yet, or nothing left to do
    const Pose& base_in_map = ins->value.base_in_map;
    if (!started_) {
        started_ = tick.now;
        start_m_ = base_in_map.position_m;
        lowest_m_ = start_m_->z();
    }
    port.publish(agent::PoseEstimate{tick.now, base_in_map});
    if (paused_)
        port.send(safeCommand(), "paused");
    else
        port.send(decide(base_in_map.position_m, tick.now), inWords());
    tell(tick.now, port);
}

protocol::AerialDrive Hop::decide(const Vec3& position_m, Seconds now) {
    const double height_m = position_m.z() - start_m_->z();
    flown_m_ = (position_m - *start_m_).head<2>().norm();
    if (state_ == State::Climb && height_m >= parameters_.real("height_m"))
        state_ = State::Fly;
    if (state_ == State::Fly && flown_m_ >= parameters_.real("distance_m"))
        state_ = State::Land;
    if (state_ == State::Climb || state_ == State::Fly)
        lowest_m_ = position_m.z();
    if (state_ == State::Climb)
        return {climb_m_s, 0.0, 0.0, 0.0};
    if (state_ == State::Fly)
        return {0.0, forward_m_s, 0.0, 0.0};

    if (position_m.z() < lowest_m_ - still_m || !still_since_) {
        lowest_m_ = position_m.z();
        still_since_ = now;
    }
    if (now - *still_since_ < on_the_ground)
        return {sink_m_s, 0.0, 0.0, 0.0};
    state_ = State::Done;
    return {0.0, 0.0, 0.0, 0.0};
}

/// Publishes what the window shows: state, distance and progress with every tick, and the result at the end.
void Hop::tell(Seconds now, agent::CommandPort& port) const {
    const double whole_m = parameters_.real("distance_m");
    agent::BehaviorStatus status;
    status.time = now;
    status.elapsed = now - *started_;
    status.state = inWords();
    status.distance_flown_m = flown_m_;
    status.progress_pct = state_ == State::Done ? 100.0
                          : whole_m > 0.0       ? std::min(99.0, 99.0 * flown_m_ / whole_m)
                                                : 0.0;
    status.paused = paused_;
    port.publish(status);
    if (state_ == State::Done)
        port.publish(agent::BehaviorFinished{true, "The hop is done; the robot is on the ground."});
}

void Hop::order(agent::Order order, agent::CommandPort& port) {
    if (order == agent::Order::LandNow && state_ != State::Done)
        state_ = State::Land;
    paused_ = order == agent::Order::Pause;
    if (paused_)
        port.send(safeCommand(), "paused");
}

const char* Hop::inWords() const {
    static constexpr std::array words{"climbing", "flying forward", "landing", "on the ground"};
    return words[static_cast<std::size_t>(state_)];
}

} // namespace usar::sample
