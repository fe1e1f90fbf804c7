// The drive of a robot: wheels, rotors, fins or legs. It obeys its own kind of DRIVE and nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/protocol/command.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/robot_state.h"
#include "core/sim/physics/physics.h"
#include "core/sim/robots/robot_model.h"
#include "core/sim/robots/robot_watches.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Moves one body, which outlives it. Belongs to one robot.
class Drive {
public:
    virtual ~Drive() = default;

    /// Returns false for a command that is meant for another kind of vehicle.
    virtual bool obey(const protocol::Command& command) = 0;
    /// Applies forces and motors for the next physics step.
    virtual void beforeStep(Seconds dt) = 0;
    /// Evaluates the contacts of the physics step that was made, and updates the counters.
    virtual void afterStep(Seconds /*dt*/) {}
    /// Called when the battery is empty; from then on the drive exerts no force.
    virtual void switchOff() = 0;
    /// Sets the velocity of the air (map frame), which matters only to flying robots.
    virtual void feelWind(const Vec3& /*wind_in_map_m_s*/) {}
    /// Makes rotor 1..4 give only this share of its thrust, if there are rotors.
    virtual void weakenRotor(int /*rotor*/, double /*share*/) {}
    /// True if nothing pushes, so that the body may count as standing still, which the INS needs to know.
    virtual bool idle() const = 0;
    /// True if the robot can no longer move because it was damaged.
    virtual bool broken() const { return false; }
    /// True if a fault takes thrust from it.
    virtual bool weak() const { return false; }
    /// Contacts that this kind of drive counts as collisions.
    int collisions() const { return collisions_.count(); }

    /// Add the terms of this kind of drive to STA, GEO and CONF.
    virtual void addState(protocol::RobotState&) const {}
    virtual void addGeometry(protocol::GeometryInfo&) const {}
    virtual void addSettings(std::vector<protocol::Setting>&) const {}

protected:
    CollisionCounter collisions_;
};

/// Makes the drive that the model names: rotors, skid, ackermann, omni, nautic, legs, or none for what stands. Fails if
/// the model lacks something for it, and names what. A flying robot `near_ground` lands by itself. All references must
/// outlive the drive.
Result<std::unique_ptr<Drive>> makeDrive(const RobotModel& model, Physics& physics, BodyId body, const World& world,
                                         bool near_ground);

/// Clamps a value to -limit..limit. `normalized` values are hundredths of the limit. NaN gives 0.
inline double limited(double value, double limit, bool normalized) {
    const double physical = normalized ? value / 100.0 * limit : value;
    return std::isnan(physical) ? 0.0 : std::clamp(physical, -limit, limit);
}
/// Sets `value` to a term of a DRIVE, limited. A term that is left out changes nothing.
inline void takeTerm(const std::optional<double>& term, double limit, bool normalized, double& value) {
    if (term)
        value = limited(*term, limit, normalized);
}

} // namespace usar::sim
