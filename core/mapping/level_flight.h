// Corrects the roll and pitch of an inertial navigation system (INS) by what the dynamics of steady flight say.
#pragma once

#include <deque>
#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::mapping {

/// The INS of the AirRobot adds noise to every change of an angle (robots-and-worlds.md 4.4), so its roll and pitch are
/// random walks that return to the truth only when it is set. A robot that is carried by the thrust along its z axis
/// leans in steady, calm flight exactly so much that the thrust carries its weight and overcomes its drag: at the speed
/// v along the direction of the lean, by v^2 / v_t^2 in rad, where v_t is its speed in free fall, at which the drag is
/// the weight. So the roll is 0 and the pitch is positive (nose down) when it flies straight ahead. For each of the two
/// angles a Kalman filter with one state tells the drift, which is the INS's angle minus that of the dynamics, without
/// what passes quickly: the corrected pitch is the INS's, high-passed, plus what the dynamics give at that speed.
///
/// A flight is steady if it has not turned, climbed, accelerated or begun to lean for a second. In wind the robot leans
/// for another reason: a lean that the drift cannot explain, for some seconds, is taken for a jump of the drift the
/// first times, as after a collision; when it is large or comes again, as it does with each turn in wind, it ends the
/// corrections until the INS is set again.
/// Uses nothing but the robot's own estimates. A plain value; its owner hands in the time.
class LevelFlight {
public:
    /// v_t of the AirRobot (robots-and-worlds.md 3.1).
    static constexpr double free_fall_m_s = 7.0;

    /// Takes the robot's estimate of its pose; call it for every estimate, in order.
    void take(Seconds now, const Pose& base_in_map);
    /// The INS was set: its roll and pitch are those of the robot now, up to the rounding of the wire.
    void insWasSet();

    /// The estimate without the drift. In steady flight the roll is that of the dynamics alone, which have no noise.
    /// Position and yaw stay as they are; in wind, roll and pitch do too.
    Pose corrected(const Pose& base_in_map) const;
    bool steady() const { return steady_; }
    bool calm() const { return calm_; }
    /// Drift of roll and pitch that is believed now, in rad.
    Vec2 drift_rad() const { return drift_rad_; }
    /// Standard deviation of what is believed of the drift, the greater one of the two angles, in rad.
    double doubt_rad() const;

private:
    struct Estimate {
        Seconds time{0.0};
        Pose base_in_map;
    };
    /// The newest estimate that is at least as old as `age`; nullptr if there is none.
    const Estimate* before(Seconds age) const;
    /// Velocity relative to the yaw (forward, left), in m/s; nullopt unless the flight is steady.
    std::optional<Vec2> steadyVelocity_m_s() const;
    /// Takes roll and pitch, in rad, as they are minus what the dynamics say.
    void learn(const Vec2& shown_rad);
    /// Roll and pitch of the steady flight according to the dynamics.
    Vec2 lean_rad() const;

    std::deque<Estimate> recent_;
    Vec2 velocity_m_s_ = Vec2::Zero(); ///< The steady flight has it.
    bool steady_ = false;
    bool calm_ = true;
    int steady_outliers_ = 0;
    int surprises_ = 0; ///< how often the drift has jumped since the INS was set
    Vec2 drift_rad_ = Vec2::Zero();
    Vec2 variance_rad2_ = Vec2::Zero();
};

} // namespace usar::mapping
