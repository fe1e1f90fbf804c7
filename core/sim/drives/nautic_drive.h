// A submarine's propeller, rudder and stern plane, and the water around its hull.
#pragma once

#include "core/sim/robots/drive.h"

namespace usar::sim {

/// Figures of a torpedo-shaped hull along the base's x axis. The usual values are those of the published REMUS model
/// (robots-and-worlds.md 3.3); the drive of a robot file can replace each of them by its name.
struct HullFigures {
    Numbers numbers{}; ///< figures that replace the usual ones, by name
    double radius_m = numberOr(numbers, "hull_radius", 0.095);
    double length_m = numberOr(numbers, "hull_length", 1.6);
    double volume_m3 = numberOr(numbers, "volume", 0.0); ///< 0: trimmed to hover in the water of its world
    /// Height of the center of buoyancy above the base's origin.
    double buoyancy_z_m = numberOr(numbers, "center_of_buoyancy", 0.0);
    // Drag is coefficient * speed^2, a force or a torque. Added mass is that of a fully submerged hull.
    double surge_drag_kg_m = numberOr(numbers, "surge_drag", 3.9);
    double cross_drag_kg_m = numberOr(numbers, "cross_drag", 131.0);
    double roll_drag_kg_m2 = numberOr(numbers, "roll_drag", 0.13);
    double pitch_drag_kg_m2 = numberOr(numbers, "pitch_drag", 188.0);
    double yaw_drag_kg_m2 = numberOr(numbers, "yaw_drag", 94.0);
    double surge_added_mass_kg = numberOr(numbers, "surge_added_mass", 0.93);
    double cross_added_mass_kg = numberOr(numbers, "cross_added_mass", 35.5);
    double turn_added_inertia_kg_m2 = numberOr(numbers, "turn_added_inertia", 4.88);
    double fin_lift_kg_m = numberOr(numbers, "fin_lift", 9.64);   ///< force = lift * speed^2 * angle
    double fin_moment_kg = numberOr(numbers, "fin_moment", 6.15); ///< moment = this * speed^2 * angle
    double propeller_limit_rad_s = numberOr(numbers, "propeller_limit", 160.0);
    double thrust_limit_n = numberOr(numbers, "thrust_limit", 10.0); ///< at the limit; quadratic below
    double rudder_limit_rad = numberOr(numbers, "rudder_limit", 0.35);
    double stern_plane_limit_rad = numberOr(numbers, "stern_plane_limit", 0.35);
    double fin_rate_rad_s = numberOr(numbers, "fin_rate", 1.0); ///< turning rate of rudder and stern plane
};

/// Buoyancy acts slice by slice along the hull, so that it floats, dives and plunges in any attitude. Quadratic drag
/// never reverses a motion within a step. Added mass reduces every force that is not a contact; its Coriolis part is
/// left out. Positive angles turn right and lift the nose, like the wire's positive yaw and pitch. Without water the
/// body just falls.
class NauticDrive : public Drive {
public:
    /// `model` and `physics` must outlive it.
    NauticDrive(const RobotModel& model, Physics& physics, BodyId body, const World& world);

    /// Obeys protocol::NauticDrive alone; values are clamped to the hull's limits, absent ones stay in force.
    bool obey(const protocol::Command& command) override;
    /// Turns fins and propeller toward the commanded values, then applies the forces of the water.
    void beforeStep(Seconds dt) override;
    /// Counts a collision if anything touches the hull after the step, including the bottom of the sea.
    void afterStep(Seconds dt) override;
    /// Lets the propeller run down; the fins keep their commanded angles.
    void switchOff() override;
    /// True as long as the propeller is commanded to stand still.
    bool idle() const override;
    /// Adds SternPlaneAngle and RudderAngle in rad.
    void addState(protocol::RobotState& state) const override;
    /// The names of the limits are ours, because no source gives UT2004's (robots-and-worlds.md 2).
    void addSettings(std::vector<protocol::Setting>& settings) const override;

private:
    /// A force and a torque on the body.
    struct Wrench {
        Vec3 force_n = Vec3::Zero(); ///< body frame, at the center of mass
        Vec3 torque_n_m = Vec3::Zero();
    };
    /// Share of the hull that is under water, 0 to 1; adds the lift of that part to `buoyancy`.
    double submergedShare(const BodyState& state, Wrench& buoyancy) const;
    /// Weight of the whole robot about the base's center of mass; links pull at their own places.
    Wrench weight(const BodyState& state) const;
    /// Velocities are in the body's frame; each part is at most what stops the motion within `dt_s`.
    Wrench drag(const Vec3& velocity_m_s, const Vec3& rate_rad_s, double share, double dt_s) const;
    /// Thrust of the propeller and forces on the fins, which grow with the square of the forward speed.
    Wrench propulsion(double surge_m_s, double share) const;
    /// Fins turn at a constant rate; the propeller follows with a lag.
    void turnFins(double dt_s);

    const RobotModel& model_;
    Physics& physics_;
    BodyId body_;
    std::optional<Water> water_;
    HullFigures hull_;
    Vec3 inertia_kg_m2_;
    double mass_kg_;
    /// Current values; the commanded ones are below.
    double propeller_rad_s_ = 0.0;
    double rudder_rad_ = 0.0;
    double stern_plane_rad_ = 0.0;
    double wanted_propeller_rad_s_ = 0.0;
    double wanted_rudder_rad_ = 0.0;
    double wanted_stern_plane_rad_ = 0.0;
};

} // namespace usar::sim
