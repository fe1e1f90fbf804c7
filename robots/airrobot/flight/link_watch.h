// Notices that commands and readings come late, by the echo of the robot's own motion.
#pragma once

#include <deque>
#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "robots/airrobot/flight/link_probe.h"

namespace usar::airrobot {

/// The readings bear the time of the server and are the robot's only clock, so a late link does not show in their age.
/// It shows in how long the robot takes to do what it is told: the commanded velocities are found again, later, in the
/// measured ones. The delay with which they fit best is that of the link, both ways, and of the robot itself. Before it
/// has moved enough for that, the time that it takes to leave the ground tells it. Owned by one robot.
class LinkWatch {
public:
    /// A motion in the robot's frame that was commanded, or measured, in one tick.
    struct Motion {
        Vec3 velocity_m_s = Vec3::Zero();
        double yaw_rate_rad_s = 0.0;
    };

    /// Takes what is measured in a tick, and the command before it. `free`: nothing but the command moves the robot.
    /// Call it once per tick.
    void note(Seconds now, const Motion& commanded, const Motion& measured, bool free);
    /// Asks the server, whose answers tell it sooner and better; a server may give none. Call it once per tick.
    void ask(Seconds now, agent::CommandPort& port) { probe_.step(now, port); }
    /// Takes every info line, among which are the answers.
    void hear(const protocol::InfoMessage& message) { probe_.hear(message); }
    /// How much later than usual the robot obeys; 0 unless that is sure.
    Seconds late() const { return probe_.late().value_or(late_); }

private:
    using Values = Eigen::Vector4d;
    struct Entry {
        Seconds at{0.0};
        Values commanded = Values::Zero(); ///< smoothed as the robot's inertia does
        Values measured = Values::Zero();
        bool free = false;
    };

    void estimate();
    void noteLiftOff(Seconds now, double commanded_climb_m_s, double climb_m_s);
    /// The share of the measured motion that the command of so many entries before does not explain; nullopt if there
    /// was too little motion to tell.
    std::optional<double> unexplained(std::size_t delay) const;

    LinkProbe probe_;
    std::deque<Entry> entries_;           ///< oldest first
    std::optional<Seconds> told_to_lift_; ///< while it stands on the ground
    Seconds late_{0.0};
    Seconds estimated_{0.0};               ///< time of the last estimate
    std::optional<std::size_t> candidate_; ///< the last estimate, which must be found twice
};

} // namespace usar::airrobot
