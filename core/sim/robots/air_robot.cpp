#include "core/sim/robots/air_robot.h"

#include <cmath>

#include "core/base/text.h"
#include "core/sim/robots/spawn_place.h"

namespace usar::sim {

namespace {

AirRobotSpawn spawnOf(const RobotSurroundings& surroundings, const RobotOptions& options) {
    const double below_m = heightOverGround_m(surroundings, options.base_in_map.position_m);
    AirRobotSpawn spawn{options.base_in_map, below_m < near_ground_m, options.battery_life, {}};
    if (surroundings.world.water)
        spawn.water_z_m = surroundings.world.water->surface_z_m;
    return spawn;
}

} // namespace

Result<std::unique_ptr<Robot>> AirRobot::spawn(const RobotSurroundings& surroundings, const RobotOptions& options) {
    const std::optional<Pose> pose = freePose(surroundings, bodyOf(AirRobotParameters{}), options.base_in_map);
    if (!pose)
        return failure("no room to spawn a robot there", "INIT",
                       "Choose a start pose above the ground, clear of trees and of other robots");
    RobotOptions free_options = options;
    free_options.base_in_map = *pose;
    return std::make_unique<AirRobot>(surroundings, free_options);
}

AirRobot::AirRobot(const RobotSurroundings& surroundings, const RobotOptions& options)
    : body_(surroundings.physics, spawnOf(surroundings, options))
    , rays_(surroundings.caster, surroundings.physics, body_.id())
    , sensors_({options.base_in_map, options.seed, options.number, options.scan_interval, options.noise}) {}

void AirRobot::obey(const protocol::Command& command) {
    if (const auto* const drive = std::get_if<protocol::AerialDrive>(&command))
        body_.drive(*drive);
}

void AirRobot::measure(Seconds now, bool first, std::vector<protocol::InfoMessage>& out) {
    if (alive())
        sensors_.measure(body_.state().pose(), now, first, rays_, out);
    out.emplace_back(state(now));
}

protocol::RobotState AirRobot::state(Seconds now) const {
    protocol::RobotState state;
    state.kind = protocol::VehicleKind::Aerial;
    state.time = now;
    state.battery_left = Seconds{std::ceil(body_.batteryLeft().count() - 1e-6)}; // whole seconds, 1200 at first
    state.light_on = false;
    state.light_intensity_pct = 0;
    state.view = -1;
    return state;
}

protocol::GeometryInfo AirRobot::geometry(const std::string& type, const std::string& name) const {
    if (!sameWord(type, "Robot"))
        return sensors_.geometry(type, name);
    protocol::GeometryInfo info;
    info.type = "AerialVehicle";
    info.robot_class = "AirRobot";
    info.dimensions_m = body_.parameters().dimensions_m;
    info.center_of_gravity_m = Vec3::Zero();
    return info;
}

protocol::ConfigurationInfo AirRobot::configuration(const std::string& type, const std::string& name) const {
    if (!sameWord(type, "Robot"))
        return sensors_.configuration(type, name);
    const AirRobotParameters& p = body_.parameters();
    return {"AerialVehicle",
            {{"AirRobot",
              {{"SteeringType", "RotaryWing", {}},
               {"Mass", "", p.mass_kg},
               {"MaxLateralVelocity", "", p.sideways_limit_m_s},
               {"MaxLinearVelocity", "", p.forward_limit_m_s},
               {"MaxAltitudeVelocity", "", p.climb_limit_m_s},
               {"MaxRotationalVelocity", "", p.yaw_rate_limit_rad_s}}}}};
}

bool AirRobot::set(const protocol::SetInsPose& wanted) {
    return sensors_.setIns(wanted, body_.atRest());
}

RobotFigures AirRobot::figures() const {
    const BodyState now = body_.state();
    return {now.pose(), now.velocity_m_s, body_.broken(), body_.collisions(), body_.distance_m()};
}

} // namespace usar::sim
