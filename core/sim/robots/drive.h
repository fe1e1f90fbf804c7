// What makes a robot move: wheels, rotors, fins or legs. It obeys its kind of DRIVE and nothing else.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/protocol/command.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/robot_state.h"
#include "core/sim/physics.h"
#include "core/sim/robots/robot_model.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Made for one body, which outlives it. Belongs to one robot.
class Drive {
public:
    virtual ~Drive() = default;

    /// False for what is meant for another kind of vehicle.
    virtual bool obey(const protocol::Command& command) = 0;
    /// Forces and motors for the next physics step.
    virtual void beforeStep(Seconds dt) = 0;
    /// Contacts and counters of the step that was made.
    virtual void afterStep(Seconds /*dt*/) {}
    /// The battery is empty: no force any more.
    virtual void switchOff() = 0;
    /// The air moves (map frame); of no account to what does not fly.
    virtual void feelWind(const Vec3& /*wind_in_map_m_s*/) {}
    /// Rotor 1..4 gives this share of its thrust. False where there are no rotors.
    virtual bool weakenRotor(int /*rotor*/, double /*share*/) { return false; }
    /// Nothing pushes, so that the body may be taken as standing still (the INS wants to know).
    virtual bool idle() const = 0;
    virtual bool broken() const { return false; }
    virtual int collisions() const { return 0; }

    /// The kind's own terms of STA, GEO and CONF.
    virtual void addTo(protocol::RobotState&) const {}
    virtual void addTo(protocol::GeometryInfo&) const {}
    virtual void addTo(std::vector<protocol::Setting>&) const {}
};

/// Where a robot appears.
struct DriveBirth {
    Pose base_in_map;
    bool near_ground = false; ///< then what flies settles down by itself
};

/// Fails where the model's drive lacks something, naming it. What it is given must outlive it.
Result<std::unique_ptr<Drive>> makeDrive(const RobotModel& model, Physics& physics, BodyId body, const World& world,
                                         const DriveBirth& birth);

} // namespace usar::sim
