#include "tests/doubles/toy_airrobot.h"

#include <algorithm>
#include <cmath>

#include "tests/doubles/toy_time.h"

namespace usar::test {

namespace {

constexpr double lag_s = 0.35;
constexpr double gravity_m_s2 = 9.81;
constexpr double leg_m = 0.2;
constexpr double airrobot_radius_m = 0.5;

double toward(double value, double goal, double dt_s) {
    return value + (goal - value) * std::min(1.0, dt_s / lag_s);
}

Vec3 turned(const Vec3& vector, double yaw_rad) {
    return Eigen::AngleAxisd(yaw_rad, Vec3::UnitZ()) * vector;
}

} // namespace

ToyAirRobot::ToyAirRobot(ToyWorld world, const Pose& start_in_map, ToyFaults faults, Seconds battery)
    : world_(std::move(world))
    , faults_(std::move(faults))
    , base_(start_in_map)
    , ins_(start_in_map)
    , ins_last_(start_in_map)
    , battery_(battery) {
    base_.position_m.z() = world_.ground_m(base_.position_m.head<2>()) + leg_m;
    ins_ = ins_last_ = base_;
}

void ToyAirRobot::obey(const protocol::Command& command) {
    if (const auto* drive = std::get_if<protocol::AerialDrive>(&command)) {
        drive_ = *drive;
    } else if (const auto* geometry = std::get_if<protocol::GetGeometry>(&command)) {
        if (faults_.silent_geometry)
            return;
        protocol::GeometryInfo answer;
        answer.type = geometry->type;
        if (geometry->type == "Sonar")
            for (const airrobot::SonarMount& sonar : layout_.sonars)
                answer.items.push_back({sonar.name, sonar.sonar_in_base, "HARD"});
        else
            answer.items.push_back({"Scanner1", layout_.scanner_in_base, "HARD"});
        answers_.push_back(answer);
    } else if (const auto* configuration = std::get_if<protocol::GetConfiguration>(&command)) {
        const double maximum = configuration->type == "Sonar" ? 5.0 : 20.0;
        protocol::ConfigurationInfo answer{configuration->type == "Robot" ? "AerialVehicle" : configuration->type,
                                           {{"X", {{"MaxRange", "", maximum}}}}};
        if (configuration->type == "Robot")
            answer.items[0].settings = {{"MaxLinearVelocity", "", faults_.slow ? 0.7 : 2.0},
                                        {"MaxAltitudeVelocity", "", faults_.slow ? 0.6 : 2.0}};
        answers_.push_back(answer);
    } else if (const auto* set = std::get_if<protocol::SetInsPose>(&command)) {
        if (on_ground_)
            ins_ = set->base_in_map;
        if (!faults_.no_response)
            answers_.push_back(
                protocol::Response{.time = now_, .type = "INS", .name = set->sensor_name, .ok = on_ground_});
    }
}

void ToyAirRobot::move(double dt_s) {
    const Vec3 wanted(drive_.forward_m_s.value_or(0.0), drive_.left_m_s.value_or(0.0), drive_.climb_m_s.value_or(0.0));
    const Vec3 goal_m_s = on_ground_ && wanted.z() <= 0.0 ? Vec3::Zero() : turned(wanted, base_.yaw_rad);
    const Vec3 before_m_s = velocity_m_s_;
    for (int axis = 0; axis < 3; ++axis)
        velocity_m_s_[axis] = toward(velocity_m_s_[axis], goal_m_s[axis], dt_s);
    yaw_rate_rad_s_ = toward(yaw_rate_rad_s_, on_ground_ ? 0.0 : drive_.yaw_rate_rad_s.value_or(0.0), dt_s);
    base_.yaw_rad = normalizedAngle(base_.yaw_rad + yaw_rate_rad_s_ * dt_s);
    const Vec3 level_m_s2 = turned((velocity_m_s_ - before_m_s) / dt_s, -base_.yaw_rad);
    base_.pitch_rad = on_ground_ ? 0.0 : level_m_s2.x() / gravity_m_s2;
    base_.roll_rad = on_ground_ ? 0.0 : -level_m_s2.y() / gravity_m_s2;
    base_.position_m += velocity_m_s_ * dt_s;
    if (faults_.lid_z_m && base_.position_m.z() > *faults_.lid_z_m) {
        base_.position_m.z() = *faults_.lid_z_m;
        velocity_m_s_.z() = std::min(velocity_m_s_.z(), 0.0);
    }
    const double floor_m = world_.ground_m(base_.position_m.head<2>()) + leg_m;
    on_ground_ = base_.position_m.z() <= floor_m && wanted.z() <= 0.0;
    if (base_.position_m.z() <= floor_m) {
        if (velocity_m_s_.z() < -1.0)
            ++collisions_;
        base_.position_m.z() = floor_m;
        velocity_m_s_ = on_ground_ ? Vec3::Zero() : velocity_m_s_.cwiseMax(Vec3(-2.0, -2.0, 0.0)).eval();
    }
}

void ToyAirRobot::integrateIns() {
    const Vec3 step_m = base_.position_m - ins_last_.position_m;
    const double turn_rad = normalizedAngle(base_.yaw_rad - ins_last_.yaw_rad);
    rest_scans_ += step_m.norm() < 1e-6 ? 1 : 0;
    ins_last_ = base_;
    if (rest_scans_ < 2)
        return;
    const double sigma = faults_.ins_drifts ? 0.05 : 0.0;
    for (int axis = 0; axis < 3; ++axis)
        ins_.position_m[axis] += step_m[axis] + step_m.norm() * gaussian(random_, 1.0) * sigma;
    ins_.yaw_rad = normalizedAngle(ins_.yaw_rad + turn_rad * (1.0 + sigma * gaussian(random_, 1.0)));
    ins_.roll_rad = base_.roll_rad;
    ins_.pitch_rad = base_.pitch_rad;
}

protocol::SonarReadings ToyAirRobot::sonars() const {
    protocol::SonarReadings readings{now_, {}};
    for (const airrobot::SonarMount& mount : layout_.sonars) {
        const Pose sonar_in_map = base_ * mount.sonar_in_base;
        double range_m = mount.maximum_m;
        for (int k = 0; k < 17; ++k) {
            const double half_rad = k == 0 ? 0.0 : k <= 8 ? mount.beam_rad / 4.0 : mount.beam_rad / 2.0;
            const double around_rad = k * pi / 4.0;
            const Vec3 ray(1.0, std::tan(half_rad) * std::cos(around_rad), std::tan(half_rad) * std::sin(around_rad));
            range_m = std::min(range_m, world_.cast(sonar_in_map.position_m, sonar_in_map.rotation() * ray.normalized(),
                                                    mount.maximum_m));
        }
        readings.ranges.push_back({mount.name, range_m});
    }
    return readings;
}

protocol::RangeScan ToyAirRobot::scan() const {
    protocol::RangeScan scan{now_, "Scanner1", radians(1.0), pi, {}};
    const Pose scanner_in_map = base_ * layout_.scanner_in_base;
    const Eigen::Quaterniond rotation = scanner_in_map.rotation();
    scan.ranges_m.resize(181);
    for (std::size_t k = 0; k < scan.ranges_m.size(); ++k) {
        const double angle_rad = scan.beamAngle_rad(k);
        const Vec3 ray = rotation * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0);
        scan.ranges_m[k] = world_.cast(scanner_in_map.position_m, ray, layout_.scanner_maximum_m);
    }
    return scan;
}

std::vector<protocol::InfoMessage> ToyAirRobot::step() {
    for (int i = 0; i < substeps; ++i)
        move(tick_s / substeps);
    now_ += Seconds(tick_s);
    battery_ -= Seconds(tick_s);
    integrateIns();
    if (!on_ground_) {
        const double clearance_m = world_.distance_m(base_.position_m) - airrobot_radius_m;
        const double over_ground_m = base_.position_m.z() - world_.ground_m(base_.position_m.head<2>());
        if (clearance_m < 0.0 && over_ground_m > 1.0)
            ++collisions_;
        if (over_ground_m > 2.0)
            lowest_clearance_m_ = std::min(lowest_clearance_m_, clearance_m);
    }
    const Seconds age = now_ - started_;
    std::vector<protocol::InfoMessage> messages;
    const bool silent = faults_.sonars_silent_after_s && age >= Seconds(*faults_.sonars_silent_after_s);
    if (!silent || !faults_.only_silent_sonar.empty()) {
        protocol::SonarReadings readings = sonars();
        std::erase_if(readings.ranges,
                      [&](const auto& range) { return silent && range.name == faults_.only_silent_sonar; });
        messages.push_back(std::move(readings));
    }
    messages.push_back(scan());
    if (!faults_.ins_silent_after_s || age < Seconds(*faults_.ins_silent_after_s))
        messages.push_back(protocol::InsReading{std::nullopt, "INS", ins_});
    messages.push_back(protocol::GroundTruthReading{now_, "GroundTruth", base_});
    messages.insert(messages.end(), answers_.begin(), answers_.end());
    answers_.clear();
    protocol::RobotState state;
    state.kind = protocol::VehicleKind::Aerial;
    state.time = now_;
    state.battery_left = battery_;
    messages.push_back(state);
    return messages;
}

ToyFlight::ToyFlight(ToyAirRobot robot, std::unique_ptr<agent::Behavior> behavior)
    : robot_(std::move(robot))
    , host_(std::move(behavior), "airrobot/test") {}

void ToyFlight::keep(agent::BehaviorHost::Output output) {
    for (agent::CausedCommand& caused : output.commands) {
        robot_.obey(caused.command);
        commands_.push_back(std::move(caused));
    }
    for (agent::Published& value : output.published) {
        if (const auto* status = std::get_if<agent::BehaviorStatus>(&value)) {
            status_ = *status;
            if (states_.empty() || states_.back() != status_.state)
                states_.push_back(status_.state);
        }
        published_.push_back(std::move(value));
    }
}

void ToyFlight::tick() {
    for (protocol::InfoMessage& message : robot_.step()) {
        ++line_.value;
        keep(host_.receive({line_, "", std::move(message), {}}));
    }
    path_m_.push_back(robot_.position_m());
}

void ToyFlight::run(Seconds limit) {
    const Seconds end = robot_.now() + limit;
    while (!host_.finished() && robot_.now() < end)
        tick();
}

void ToyFlight::order(agent::Order order) {
    keep(host_.order(order));
}

std::optional<agent::BehaviorFinished> ToyFlight::ending() const {
    for (const agent::Published& value : published_)
        if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value))
            return *finished;
    return std::nullopt;
}

std::vector<agent::MapMark> ToyFlight::marks(agent::MarkKind kind) const {
    std::vector<agent::MapMark> found;
    for (const agent::Published& value : published_)
        if (const auto* mark = std::get_if<agent::MapMark>(&value); mark && mark->kind == kind)
            found.push_back(*mark);
    return found;
}

std::vector<std::string> ToyFlight::events() const {
    std::vector<std::string> texts;
    for (const agent::Published& value : published_)
        if (const auto* event = std::get_if<agent::BehaviorEvent>(&value))
            texts.push_back(event->text);
    return texts;
}

} // namespace usar::test
