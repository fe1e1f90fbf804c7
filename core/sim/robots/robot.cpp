#include "core/sim/robots/robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/vehicle_words.h"
#include "core/sim/robots/spawn_place.h"

namespace usar::sim {

namespace {

constexpr double asleep_m_s = 0.01;
constexpr double asleep_rad_s = 0.01;
constexpr double raised_to_turn_m = 0.3;
constexpr int rotors = 4;

const protocol::DriveSwitches* switchesOf(const protocol::Command& command) {
    return std::visit(
        [](const auto& one) -> const protocol::DriveSwitches* {
            if constexpr (std::is_same_v<std::decay_t<decltype(one)>, protocol::DriveSwitches>)
                return &one;
            else if constexpr (requires { one.switches; })
                return &one.switches;
            else
                return nullptr;
        },
        static_cast<const protocol::CommandVariant&>(command));
}

} // namespace

Result<std::unique_ptr<Robot>> Robot::spawn(const RobotModel& model, const RobotSurroundings& surroundings,
                                            const RobotOptions& options) {
    const std::optional<Pose> pose = freePose(surroundings, model.whole(), options.base_in_map);
    if (!pose)
        return failure("no room to spawn a robot there", "INIT",
                       "Choose a start pose above the ground, clear of trees and of other robots");
    RobotOptions free_options = options;
    free_options.base_in_map = *pose;
    std::unique_ptr<Robot> robot(new Robot(model, surroundings, free_options));
    if (auto done = robot->equip(surroundings, free_options); !done)
        return tl::unexpected(done.error());
    return robot;
}

Robot::Robot(const RobotModel& model, const RobotSurroundings& surroundings, const RobotOptions& options)
    : body_(surroundings.physics, model, options.base_in_map)
    , stay_(options.base_in_map.position_m)
    , rays_(surroundings.caster, surroundings.physics, body_.id())
    , world_(surroundings.world)
    , scene_(surroundings.scene)
    , tick_(options.scan_interval)
    , battery_left_(options.battery_life.value_or(model.battery_life)) {}

Result<void> Robot::equip(const RobotSurroundings& surroundings, const RobotOptions& options) {
    const RobotModel& model = body_.model();
    const double height_m = heightOverGround_m(surroundings, options.base_in_map.position_m);
    auto drive =
        makeDrive(model, surroundings.physics, body_.id(), world_, {options.base_in_map, height_m < near_ground_m});
    if (!drive)
        return tl::unexpected(drive.error());
    drive_ = std::move(*drive);
    auto sensors = SensorSuite::make(model, options);
    if (!sensors)
        return tl::unexpected(sensors.error());
    sensors_ = std::move(*sensors);
    for (const PackageModel& package : model.packages)
        packages_.emplace_back(package, body_);
    return {};
}

bool Robot::obey(const protocol::Command& command) {
    if (const auto* const switches = switchesOf(command)) {
        light_on_ = switches->light_on.value_or(light_on_);
        if (switches->flip.value_or(false))
            rightItself();
    }
    const bool for_package =
        std::ranges::any_of(packages_, [&](MissionPackage& package) { return package.obey(command); });
    return for_package || drive_->obey(command) || std::holds_alternative<protocol::DriveSwitches>(command);
}

/// Turns the robot level again and lifts it clear of what it lay on.
void Robot::rightItself() {
    Pose level = body_.base_in_map();
    level.position_m.z() += raised_to_turn_m;
    level.roll_rad = level.pitch_rad = 0.0;
    body_.physics().place(body_.id(), level * Pose{.position_m = body_.model().center_of_mass_in_base_m});
}

void Robot::afterStep(Seconds dt) {
    body_.afterStep();
    drive_->afterStep(dt);
    touches_.pass(dt);
    for (const Contact& contact : body_.physics().contacts(body_.id()))
        if (contact.surface == Surface::Body)
            touches_.touch();
    discharge(dt);
}

/// Counts down the battery. Water ends the battery of a robot that was not made for it (protocol.md 2.6).
void Robot::discharge(Seconds dt) {
    if (!alive())
        return;
    battery_left_ = std::max(Seconds{0.0}, battery_left_ - dt);
    const bool swims = body_.model().kind == protocol::VehicleKind::Nautic;
    if (!swims && world_.water && body_.base_in_map().position_m.z() < world_.water->surface_z_m)
        battery_left_ = Seconds{0.0};
    if (!alive())
        switchOff();
}

void Robot::switchOff() {
    drive_->switchOff();
    for (MissionPackage& package : packages_)
        package.switchOff();
}

void Robot::measure(Seconds now, bool first, std::vector<protocol::InfoMessage>& out) {
    watch();
    if (alive()) {
        sensors_.measure({now, tick_, body_, rays_, world_, scene_}, first, out);
        for (const MissionPackage& package : packages_)
            out.emplace_back(package.state(now));
    }
    body_.forgetTouches();
    out.emplace_back(state(now));
}

void Robot::watch() {
    const Eigen::Isometry3d base_in_map = body_.link_in_map(-1);
    const Vec3 position_m = base_in_map.translation();
    stay_.step(tick_, position_m);
    falls_.step(base_in_map.linear()(2, 2));
    const bool dives = body_.model().kind == protocol::VehicleKind::Nautic && world_.water && !world_.terrain.empty();
    went_under_ = went_under_ || (dives && position_m.z() < world_.water->surface_z_m);
    if (went_under_)
        heights_.step(position_m.z() - world_.terrain.height_m(position_m.head<2>()));
}

protocol::RobotState Robot::state(Seconds now) const {
    protocol::RobotState state;
    state.kind = body_.model().kind;
    state.time = now;
    state.battery_left = Seconds{std::ceil(battery_left_.count() - 1e-6)}; // In whole seconds, 1200 at first.
    state.light_on = light_on_;
    state.light_intensity_pct = light_on_ ? 100 : 0;
    state.view = -1;
    drive_->addTo(state);
    return state;
}

protocol::GeometryInfo Robot::geometry(const std::string& type, const std::string& name) const {
    const RobotModel& model = body_.model();
    protocol::GeometryInfo info;
    if (sameWord(type, "Robot")) {
        info.type = protocol::wordOf(model.kind);
        info.robot_class = model.class_name;
        info.dimensions_m = model.dimensions_m;
        info.center_of_gravity_m = model.center_of_gravity_m;
        drive_->addTo(info);
    } else if (sameWord(type, "MisPkg")) {
        info.type = "MisPkg";
        for (const MissionPackage& package : packages_)
            if (name.empty() || sameWord(package.name(), name))
                std::ranges::move(package.geometry(), std::back_inserter(info.items));
        if (info.items.empty())
            info.robot_class = name;
    } else {
        info = sensors_.geometry(type, name);
    }
    return info;
}

protocol::ConfigurationInfo Robot::configuration(const std::string& type, const std::string& name) const {
    const RobotModel& model = body_.model();
    if (sameWord(type, "Robot")) {
        protocol::ConfiguredItem item{model.class_name,
                                      {{"SteeringType", model.steering, {}}, {"Mass", "", model.mass_kg()}}};
        drive_->addTo(item.settings);
        return {std::string(protocol::wordOf(model.kind)), {std::move(item)}};
    }
    if (!sameWord(type, "MisPkg"))
        return sensors_.configuration(type, name);
    protocol::ConfigurationInfo info{"MisPkg", {}};
    for (const MissionPackage& package : packages_)
        if (name.empty() || sameWord(package.name(), name))
            info.items.push_back({package.name(), package.settings()});
    if (info.items.empty() && !name.empty())
        info.items.push_back({name, {}});
    return info;
}

std::optional<protocol::Response> Robot::set(const protocol::Command& wanted) {
    return sensors_.set(wanted, atRest());
}

void Robot::setFaults(const std::vector<Fault>& active) {
    sensors_.setFaults(active);
    for (int rotor = 1; rotor <= rotors; ++rotor)
        drive_->weakenRotor(rotor, 1.0);
    for (const Fault& fault : active) {
        if (fault.kind == FaultKind::Rotor)
            drive_->weakenRotor(static_cast<int>(fault.number("rotor")), fault.number("thrust"));
        if (fault.kind == FaultKind::Battery)
            battery_left_ = std::min(battery_left_, Seconds{fault.number("left")});
    }
    if (!alive())
        switchOff();
}

bool Robot::canHave(const Fault& fault) const {
    if (descriptionOf(fault.kind).of_sensor)
        return fault.sensor.empty() || sensors_.has(fault.sensor);
    return fault.kind != FaultKind::Rotor || body_.model().kind == protocol::VehicleKind::Aerial;
}

bool Robot::atRest() const {
    return drive_->idle() && body_.velocity_in_map_m_s().norm() < asleep_m_s &&
           body_.rate_in_map_rad_s().norm() < asleep_rad_s;
}

RobotFigures Robot::figures() const {
    return {body_.base_in_map(), body_.velocity_in_map_m_s(),
            drive_->broken(),    drive_->collisions(),
            body_.distance_m(),  stay_.longest(),
            falls_.count(),      touches_.count(),
            touches_.first(),    heights_.figures()};
}

} // namespace usar::sim
