#include "core/sim/robots/robot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/vehicle_words.h"
#include "core/sim/faults/wind_profile.h"

namespace usar::sim {

namespace {

/// A robot spawned less than this above something solid will settle on it.
constexpr double near_ground_m = 1.0;
constexpr double most_raise_m = 1.0;
constexpr double raise_step_m = 0.05;
/// Centers closer than this count as one place: two robots that settle there would land on each other.
constexpr double same_place_m = 1.2;
/// Distance between the centers of a robot that is put beside others and those others.
constexpr double beside_m = 1.8;
constexpr std::array rings_m{2.0, 3.0, 4.0};
constexpr int bearings = 12;
constexpr double most_step_m = 1.0; ///< change of ground height, from the wanted place to the one beside it
constexpr double sky_m = 30.0;
constexpr double body_half_width_m = 1.0;

/// Distance down to the fixed parts of the world; at most 2 m.
double heightOverGround_m(const RobotSurroundings& surroundings, const Vec3& position_m) {
    return surroundings.caster.cast(position_m, -Vec3::UnitZ(), 2.0 * near_ground_m);
}

/// A body for trying out places; removed when it goes out of scope.
class Probe {
public:
    Probe(Physics& physics, const BodyDescription& body, const Pose& pose)
        : physics_(physics)
        , id_(physics.add(body, pose)) {}
    ~Probe() { physics_.remove(id_); }
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;

    bool stuckAt(const Pose& pose) const {
        physics_.place(id_, pose);
        return physics_.isStuck(id_);
    }
    double roomAt_m(const Vec3& position_m) const { return physics_.distanceToBodies_m(position_m, id_); }

private:
    Physics& physics_;
    BodyId id_;
};

std::optional<Pose> raised(const Probe& probe, Pose pose, double room_m) {
    const double highest_m = pose.position_m.z() + most_raise_m;
    bool stuck = probe.stuckAt(pose);
    while (stuck && pose.position_m.z() < highest_m) {
        pose.position_m.z() += raise_step_m;
        stuck = probe.stuckAt(pose);
    }
    return stuck || probe.roomAt_m(pose.position_m) < room_m ? std::nullopt : std::optional(pose);
}

/// True if nothing is above the robot's middle and its four sides, so that it can rise.
bool underOpenSky(const RayCaster& caster, const Vec3& position_m) {
    for (const Vec2& side_m : {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0), Vec2(-1.0, 0.0), Vec2(0.0, -1.0)}) {
        const Vec3 from_m =
            position_m + Vec3(0.0, 0.0, most_raise_m) + body_half_width_m * Vec3(side_m.x(), side_m.y(), 0.0);
        if (caster.cast(from_m, Vec3::UnitZ(), sky_m) < sky_m)
            return false;
    }
    return true;
}

/// The pose moved aside by `step_m`, and kept at its height above the ground if it was near it; nullopt if there is no
/// suitable ground.
std::optional<Pose> movedAside(const RobotSurroundings& surroundings, Pose pose, const Vec2& step_m) {
    const double height_m = heightOverGround_m(surroundings, pose.position_m);
    pose.position_m.head<2>() += step_m;
    if (height_m >= near_ground_m)
        return pose;
    const Vec3 over_m = pose.position_m + Vec3(0.0, 0.0, most_step_m);
    const double reach_m = height_m + 2.0 * most_step_m;
    const double down_m = surroundings.caster.cast(over_m, -Vec3::UnitZ(), reach_m);
    if (down_m <= 0.0 || down_m >= reach_m)
        return std::nullopt; // There is a cliff, a wall, or the end of the world.
    pose.position_m.z() = over_m.z() - down_m + height_m;
    return pose;
}

std::optional<Pose> beside(const RobotSurroundings& surroundings, const Probe& probe, const Pose& wanted) {
    const bool open = underOpenSky(surroundings.caster, wanted.position_m);
    for (const double ring_m : rings_m) {
        for (int i = 0; i < bearings; ++i) {
            // The left side comes first.
            const double bearing_rad = wanted.yaw_rad + pi / 2.0 + 2.0 * pi * i / bearings;
            const auto pose =
                movedAside(surroundings, wanted, ring_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad)));
            if (!pose || (open && !underOpenSky(surroundings.caster, pose->position_m)))
                continue;
            if (const auto free = raised(probe, *pose, beside_m))
                return free;
        }
    }
    return std::nullopt;
}

/// Returns `wanted`, level and raised out of the ground by up to a meter. If another robot is there, the nearest place
/// beside it instead, 2 to 4 m away, at the same height above the ground and under an equally open sky. Returns nullopt
/// if there is no room, or only on a roof.
std::optional<Pose> freePose(const RobotSurroundings& surroundings, const BodyDescription& body, const Pose& wanted) {
    const Pose level{wanted.position_m, 0.0, 0.0, wanted.yaw_rad};
    const Probe probe(surroundings.physics, body, level);
    const bool is_taken = probe.roomAt_m(level.position_m) < same_place_m;
    const std::optional<Pose> free = is_taken ? beside(surroundings, probe, level) : raised(probe, level, same_place_m);
    return free && surroundings.caster.onRoof(free->position_m) ? std::nullopt : free;
}

constexpr double asleep_m_s = 0.01;
constexpr double asleep_rad_s = 0.01;
constexpr double raised_to_turn_m = 0.3;
constexpr int rotors = 4;

/// The word for mission packages if `type` means them, as in UDK the word for its actuators does; otherwise empty.
std::string_view packageWord(std::string_view type, protocol::Dialect profile) {
    if (profile == protocol::Dialect::Udk && sameWord(type, "Actuator"))
        return "Actuator";
    return sameWord(type, "MisPkg") ? "MisPkg" : "";
}

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
    , caster_(surroundings.caster)
    , scene_(surroundings.scene)
    , profile_(options.profile)
    , tick_(options.scan_interval)
    , battery_left_(options.battery_life.value_or(model.battery_life)) {}

Result<void> Robot::equip(const RobotSurroundings& surroundings, const RobotOptions& options) {
    const RobotModel& model = body_.model();
    const double height_m = heightOverGround_m(surroundings, options.base_in_map.position_m);
    auto drive = makeDrive(model, surroundings.physics, body_.id(), world_, height_m < near_ground_m);
    if (!drive)
        return tl::unexpected(drive.error());
    drive_ = std::move(*drive);
    auto sensors = SensorSuite::make(model, options);
    if (!sensors)
        return tl::unexpected(sensors.error());
    sensors_ = std::move(*sensors);
    for (const PackageModel& package : model.packages)
        packages_.emplace_back(package, body_);
    for (const GripperModel& gripper : model.grippers)
        grippers_.emplace_back(gripper, body_);
    return {};
}

bool Robot::obey(const protocol::Command& command) {
    if (const auto* const switches = switchesOf(command)) {
        light_on_ = switches->light_on.value_or(light_on_);
        if (switches->flip.value_or(false))
            rightItself();
    }
    for (Gripper& gripper : grippers_)
        gripper.obey(command);
    const bool for_package =
        std::ranges::any_of(packages_, [&](MissionPackage& package) { return package.obey(command); });
    return for_package || drive_->obey(command) || std::holds_alternative<protocol::DriveSwitches>(command);
}

std::optional<PackageTrouble> Robot::takeTrouble() {
    for (MissionPackage& package : packages_)
        if (auto sentence = package.takeTrouble())
            return PackageTrouble{package.name(), *std::move(sentence)};
    return std::nullopt;
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
    if (!swims && world_.water && body_.link_in_map(-1).translation().z() < world_.water->surface_z_m)
        battery_left_ = Seconds{0.0};
    if (!alive())
        switchOff();
}

void Robot::feelWind(const Vec3& wind_at_10_m_m_s) {
    if (body_.model().kind != protocol::VehicleKind::Aerial)
        return;
    const bool blows = !wind_at_10_m_m_s.isZero(0.0);
    drive_->feelWind(blows ? Vec3(windShare(heightForWind_m()) * wind_at_10_m_m_s) : Vec3(Vec3::Zero()));
}

double Robot::heightForWind_m() {
    const Vec3 here_m = body_.link_in_map(-1).translation();
    if (!floor_m_) {
        floor_m_ = caster_.floorBelow_m(here_m);
        if (world_.water)
            floor_m_ = std::max(*floor_m_, world_.water->surface_z_m);
    }
    return here_m.z() - *floor_m_;
}

void Robot::switchOff() {
    drive_->switchOff();
    for (MissionPackage& package : packages_)
        package.switchOff();
    for (Gripper& gripper : grippers_)
        gripper.switchOff();
}

void Robot::measure(Seconds now, bool first, std::vector<protocol::InfoMessage>& out) {
    watch();
    floor_m_.reset();
    const bool is_udk = profile_ == protocol::Dialect::Udk;
    if (is_udk)
        out.emplace_back(state(now)); // In UT2004 it comes last.
    if (alive()) {
        sensors_.measure({now, tick_, body_, rays_, world_, scene_}, first, out);
        for (const MissionPackage& package : packages_)
            out.emplace_back(package.state(now));
        if (is_udk) // UT2004's effecters send nothing by themselves.
            for (const Gripper& gripper : grippers_)
                out.emplace_back(gripper.state(now));
    }
    body_.forgetTouches();
    if (!is_udk)
        out.emplace_back(state(now));
}

void Robot::watch() {
    const Eigen::Isometry3d base_in_map = body_.link_in_map(-1);
    const Vec3 position_m = base_in_map.translation();
    stay_.step(tick_, position_m);
    falls_.step(base_in_map.linear()(2, 2));
    collided_.step(drive_->collisions(), position_m);
    powered_for_ = alive() && !drive_->weak() ? powered_for_ + tick_ : Seconds{0.0};
    const bool dives = body_.model().kind == protocol::VehicleKind::Nautic && world_.water && !world_.terrain.empty();
    went_under_ = went_under_ || (dives && position_m.z() < world_.water->surface_z_m);
    if (went_under_)
        heights_.step(position_m.z() - world_.terrain.height_m(position_m.head<2>()));
}

protocol::RobotState Robot::state(Seconds now) const {
    protocol::RobotState state{.kind = body_.model().kind,
                               .time = now,
                               // In whole seconds, 1200 at first.
                               .battery_left = Seconds{std::ceil(battery_left_.count() - 1e-6)},
                               .light_on = light_on_,
                               .light_intensity_pct = light_on_ ? 100 : 0,
                               .view = -1};
    drive_->addState(state);
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
        drive_->addGeometry(info);
    } else if (const std::string_view packages = packageWord(type, profile_); !packages.empty()) {
        info.type = packages;
        for (const MissionPackage& package : packages_)
            if (name.empty() || sameWord(package.name(), name))
                std::ranges::move(package.geometry(), std::back_inserter(info.items));
        if (info.items.empty())
            info.robot_class = name;
    } else if (sameWord(type, "Gripper")) {
        info.type = "Gripper";
        for (const Gripper& gripper : grippers_)
            if (name.empty() || sameWord(gripper.name(), name))
                info.items.push_back(gripper.geometry());
        if (profile_ != protocol::Dialect::Udk)
            for (protocol::MountedItem& item : info.items)
                item.tip_in_item_m.reset(); // UT2004 does not tell it (protocol.md 4.6).
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
        drive_->addSettings(item.settings);
        return {std::string(protocol::wordOf(model.kind)), {std::move(item)}};
    }
    const bool of_gripper = sameWord(type, "Gripper");
    const std::string_view packages = packageWord(type, profile_);
    if (packages.empty() && !of_gripper)
        return sensors_.configuration(type, name);
    protocol::ConfigurationInfo info{of_gripper ? "Gripper" : std::string(packages), {}};
    const auto add = [&](const auto& parts) {
        for (const auto& part : parts)
            if (name.empty() || sameWord(part.name(), name))
                info.items.push_back({part.name(), part.settings()});
    };
    of_gripper ? add(grippers_) : add(packages_);
    if (info.items.empty() && !name.empty())
        info.items.push_back({name, {}});
    return info;
}

std::optional<protocol::Response> Robot::set(const protocol::Command& wanted) {
    std::optional<protocol::Response> answer;
    for (Gripper& gripper : grippers_)
        if (auto one = gripper.set(wanted))
            answer = std::move(one);
    if (answer)
        return answer;
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
    return {body_.base_in_map(),  body_.velocity_in_map_m_s(),
            drive_->broken(),     powered_for_,
            drive_->collisions(), body_.distance_m(),
            stay_.longest(),      falls_.count(),
            touches_.count(),     touches_.first(),
            heights_.figures(),   collided_.places_m()};
}

} // namespace usar::sim
