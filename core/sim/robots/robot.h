// A robot of the simulator as the server sees it: it obeys, moves, measures and answers. Built from a robot model.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/protocol/command.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"
#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/robots/drive.h"
#include "core/sim/robots/gripper.h"
#include "core/sim/robots/mission_package.h"
#include "core/sim/robots/robot_body.h"
#include "core/sim/robots/robot_watches.h"
#include "core/sim/robots/sensor_suite.h"

namespace usar::sim {

/// The parts of the simulation that a robot interacts with. All of them outlive it.
struct RobotSurroundings {
    const World& world;
    const RayCaster& caster;
    Physics& physics;
    Scene& scene;
};

/// The package's name, and a sentence for the log.
struct PackageTrouble {
    std::string package;
    std::string sentence;
};

/// One spawned robot. Owned by its client's session.
class Robot {
public:
    /// Spawns a robot. It is raised by up to a meter until it is free, as the game's engine does, and put beside
    /// another robot that occupies its place. Fails if that is not enough, or if the model cannot be built. `model`
    /// must outlive it.
    static Result<std::unique_ptr<Robot>> spawn(const RobotModel& model, const RobotSurroundings& surroundings,
                                                const RobotOptions& options);

    /// Obeys a driving command. Returns false for those of other vehicles, which it ignores.
    bool obey(const protocol::Command& command);
    /// A mission package that was told something that it cannot do, and why; nullopt if there is none, and after it has
    /// been taken.
    std::optional<PackageTrouble> takeTrouble();
    /// Called before and after each physics step.
    void beforeStep(Seconds dt) { drive_->beforeStep(dt); }
    void afterStep(Seconds dt);

    /// Appends the lines of a tick in UT2004's order (protocol.md 9.1). The `first` tick brings only sensors that
    /// need no history.
    void measure(Seconds now, bool first, std::vector<protocol::InfoMessage>& out);
    /// With an empty battery a robot neither obeys nor answers.
    bool alive() const { return battery_left_ > Seconds{0.0}; }
    /// Answers to GETGEO and GETCONF; an empty name asks for all items of the type.
    protocol::GeometryInfo geometry(const std::string& type, const std::string& name) const;
    protocol::ConfigurationInfo configuration(const std::string& type, const std::string& name) const;
    /// Answers a SET; nullopt if no part of the robot knows the command.
    std::optional<protocol::Response> set(const protocol::Command& wanted);

    /// Sets the active faults that concern this robot, until the next call. A drained battery is not refilled when its
    /// fault ends.
    void setFaults(const std::vector<Fault>& active);
    /// True if the robot has the sensor or the rotors that the fault is about.
    bool canHave(const Fault& fault) const;
    /// Sets the velocity of the air at 10 m above the ground; nearer to it, there is less (see windShare). What is
    /// below is looked up once a tick, and only while air moves around a robot that flies.
    void feelWind(const Vec3& wind_at_10_m_m_s);

    /// The robot as it is now; the statistics count from the spawn.
    RobotFigures figures() const;
    /// True while its lamp is switched on and its battery is not empty.
    bool lightOn() const { return light_on_ && alive(); }
    /// The cameras with their current poses, but without the robot's name, which the robot does not know.
    std::vector<SeenFrom> cameras() const { return sensors_.cameras(body_); }
    const RobotBody& body() const { return body_; }

private:
    Robot(const RobotModel& model, const RobotSurroundings& surroundings, const RobotOptions& options);
    Result<void> equip(const RobotSurroundings& surroundings, const RobotOptions& options);
    bool atRest() const;
    double heightForWind_m();
    void watch();
    void discharge(Seconds dt);
    void switchOff();
    void rightItself();
    protocol::RobotState state(Seconds now) const;

    RobotBody body_;
    StayWatch stay_;
    FallWatch falls_;
    CollisionPlaces collided_;
    CollisionCounter touches_; ///< counts those of objects and other robots
    HeightWatch heights_;
    bool went_under_ = false; ///< a submarine that has been below the surface
    WorldRays rays_;
    const World& world_;
    const RayCaster& caster_;
    std::optional<double> floor_m_; ///< under it in this tick, map z; nullopt while nobody has asked
    Scene& scene_;
    std::unique_ptr<Drive> drive_;
    SensorSuite sensors_;
    std::vector<MissionPackage> packages_;
    std::vector<Gripper> grippers_;
    protocol::Dialect profile_;
    Seconds tick_;
    Seconds battery_left_;
    Seconds powered_for_{0.0}; ///< see RobotFigures
    bool light_on_ = false;
};

} // namespace usar::sim
