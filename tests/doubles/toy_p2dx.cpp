#include "tests/doubles/toy_p2dx.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/doubles/toy_time.h"

namespace usar::test {

namespace {

constexpr double wheel_radius_m = 0.097;
constexpr double wheel_separation_m = 0.337;
constexpr double p2dx_radius_m = 0.22;
constexpr double scanner_ahead_m = 0.056;
constexpr double sonars_ahead_m = 0.2;
constexpr double floor_echo_m = 0.92;
constexpr std::array<double, 8> sonar_yaws_deg{90, 50, 30, 10, -10, -30, -50, -90};

/// Where a ray enters and leaves a rectangle; enters above leaves where it misses.
struct Crossing {
    double enters_m = -1e9;
    double leaves_m = 1e9;
};

Crossing crossing(const Rectangle& box, const Vec2& from_m, const Vec2& direction) {
    Crossing found;
    for (int axis = 0; axis < 2; ++axis) {
        const double along = std::abs(direction[axis]) < 1e-12 ? 1e-12 : direction[axis];
        const double a_m = (box.min_m[axis] - from_m[axis]) / along;
        const double b_m = (box.max_m[axis] - from_m[axis]) / along;
        found.enters_m = std::max(found.enters_m, std::min(a_m, b_m));
        found.leaves_m = std::min(found.leaves_m, std::max(a_m, b_m));
    }
    return found;
}

Vec2 towards(double direction_rad) {
    return {std::cos(direction_rad), std::sin(direction_rad)};
}

} // namespace

double ToyRoom::cast(const Vec2& from_m, double direction_rad, double maximum_m, bool sees_low) const {
    const Vec2 direction = towards(direction_rad);
    double nearest_m = std::min(maximum_m, crossing(walls_m, from_m, direction).leaves_m);
    for (const ToyBox& box : boxes) {
        const Crossing through = crossing(box.at_m, from_m, direction);
        if ((sees_low || !box.low) && through.enters_m <= through.leaves_m && through.enters_m > 0.0)
            nearest_m = std::min(nearest_m, through.enters_m);
    }
    return nearest_m;
}

bool ToyRoom::touches(const Vec2& at_m) const {
    const Vec2 reach_m = Vec2::Constant(p2dx_radius_m);
    if (!walls_m.contains(at_m - reach_m) || !walls_m.contains(at_m + reach_m))
        return true;
    return std::ranges::any_of(boxes, [&](const ToyBox& box) {
        const Vec2 nearest_m = at_m.cwiseMax(box.at_m.min_m).cwiseMin(box.at_m.max_m);
        return (nearest_m - at_m).norm() < p2dx_radius_m;
    });
}

ToyP2dx::ToyP2dx(ToyRoom room, const Pose& start_in_map)
    : room_(std::move(room))
    , base_(start_in_map)
    , stays_at_m_(start_in_map.position_m.head<2>()) {}

void ToyP2dx::obey(const protocol::Command& command) {
    if (const auto* drive = std::get_if<protocol::SkidDrive>(&command))
        drive_ = *drive;
}

void ToyP2dx::move(double dt_s) {
    const double left_m_s = wheel_radius_m * drive_.left_rad_s.value_or(0.0);
    const double right_m_s = wheel_radius_m * drive_.right_rad_s.value_or(0.0);
    base_.yaw_rad = normalizedAngle(base_.yaw_rad + (right_m_s - left_m_s) / wheel_separation_m * dt_s);
    const Vec2 next_m = position_m() + towards(base_.yaw_rad) * (left_m_s + right_m_s) / 2.0 * dt_s;
    const bool touches = room_.touches(next_m);
    collisions_ += touches && !touching_ ? 1 : 0;
    touching_ = touches;
    if (touches)
        return;
    base_.position_m.head<2>() = next_m;
    base_.position_m.z() = room_.ground_m(next_m);
}

void ToyP2dx::watchStay() {
    if ((position_m() - stays_at_m_).norm() > 1.0) {
        stays_at_m_ = position_m();
        stays_since_ = now_;
    }
    longest_stay_ = std::max(longest_stay_, now_ - stays_since_);
}

std::vector<protocol::InfoMessage> ToyP2dx::step() {
    for (int i = 0; i < substeps && !stuck; ++i)
        move(tick_s / substeps);
    now_ += Seconds(tick_s);
    watchStay();
    std::vector<protocol::InfoMessage> messages;
    protocol::RobotState state;
    state.kind = protocol::VehicleKind::Ground;
    state.time = now_;
    messages.emplace_back(state);
    protocol::SonarReadings sonars{now_, {}};
    const Vec2 sonars_m = position_m() + sonars_ahead_m * towards(base_.yaw_rad);
    for (std::size_t i = 0; i < sonar_yaws_deg.size(); ++i) {
        double echo_m = floor_echo_m;
        for (const double off_deg : {-10.0, -5.0, 0.0, 5.0, 10.0})
            echo_m = room_.cast(sonars_m, base_.yaw_rad + radians(sonar_yaws_deg[i] + off_deg), echo_m, true);
        sonars.ranges.push_back({"F" + std::to_string(i + 1), echo_m});
    }
    messages.emplace_back(std::move(sonars));
    protocol::RangeScan scan{now_, "Scanner1", radians(1.0), pi, std::vector<double>(181)};
    const Vec2 scanner_m = position_m() + scanner_ahead_m * towards(base_.yaw_rad);
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam)
        scan.ranges_m[beam] = room_.cast(scanner_m, base_.yaw_rad + scan.beamAngle_rad(beam), 20.0, false);
    if (scanner_frozen && !ranges_m_.empty())
        scan.ranges_m = ranges_m_;
    ranges_m_ = scan.ranges_m;
    if (!scanner_silent)
        messages.emplace_back(std::move(scan));
    messages.emplace_back(protocol::InsReading{std::nullopt, "INS", base_});
    return messages;
}

ToyDrive::ToyDrive(ToyP2dx robot, std::unique_ptr<agent::Behavior> behavior)
    : robot_(std::move(robot))
    , host_(std::move(behavior), "p2dx/test") {}

void ToyDrive::keep(agent::BehaviorHost::Output output) {
    for (agent::CausedCommand& caused : output.commands) {
        robot_.obey(caused.command);
        commands_.push_back(std::move(caused));
    }
    for (const agent::Published& value : output.published) {
        if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
            status_ = *status;
        else if (const auto* event = std::get_if<agent::BehaviorEvent>(&value))
            events_.push_back(event->text);
        else if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value))
            ending_ = *finished;
    }
}

void ToyDrive::tick() {
    for (protocol::InfoMessage& message : robot_.step()) {
        ++line_.value;
        keep(host_.receive({line_, "", std::move(message), {}}));
    }
}

void ToyDrive::run(Seconds duration) {
    const Seconds end = robot_.now() + duration;
    while (!host_.finished() && robot_.now() < end)
        tick();
}

bool ToyDrive::runInto(const std::string& state) {
    const Seconds end = robot_.now() + Seconds(300.0);
    while (!host_.finished() && robot_.now() < end && status_.state != state)
        tick();
    return status_.state == state;
}

void ToyDrive::order(agent::Order order) {
    keep(host_.order(order));
}

} // namespace usar::test
