// The two batteries that the AirRobot watches: the simulated one of the thesis (4.1), whose capacity is a distance
// because the simulator cannot charge batteries, and the robot's own, of which the server tells the time that is left.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The distance of one charge without the reserve, in meters.
inline double usableRange_m(const Settings& settings) {
    return settings.battery_range_m * (1.0 - settings.battery_reserve_pct / 100.0);
}

/// Whether a charge is worth its time after a flight of this length: a robot in a hurry does not charge a battery of
/// which it has hardly used half. A charge sets the INS, too, which drifts by the way: after 500 m it is worth that
/// alone.
inline bool isWorthACharge(double since_charge_m, const Settings& settings) {
    constexpr double longest_drift_m = 500.0;
    return !settings.hurried() || since_charge_m > std::min(0.5 * settings.battery_range_m, longest_drift_m);
}

/// Adds up the distance flown since the last charge, according to the INS. Positions and distances are
/// three-dimensional, in meters. Owned by one robot.
class BatteryModel {
public:
    /// Adds the distance from the last position. Ignores moves of less than 3 cm, which are noise of the protocol while
    /// the robot stands still.
    void moveTo(const Vec3& position_in_map_m) {
        const double move_m = last_m_ ? (position_in_map_m - *last_m_).norm() : 0.0;
        if (last_m_ && !(move_m >= 0.03))
            return;
        since_charge_m_ += move_m;
        total_m_ += move_m;
        last_m_ = position_in_map_m;
    }
    /// Makes the next move start at its own position, because the position estimate has jumped.
    void forgetPosition() { last_m_.reset(); }
    /// Starts at 0 again; the total distance stays.
    void recharge() {
        since_charge_m_ = 0.0;
        ++charges_;
    }

    /// The total distance flown.
    double flown_m() const { return total_m_; }
    /// The number of recharges.
    int charges() const { return charges_; }
    double sinceCharge_m() const { return since_charge_m_; } ///< the distance flown since then
    /// The used share of the battery's range, 0 to 100.
    double used_pct(const Settings& settings) const {
        return std::clamp(100.0 * since_charge_m_ / settings.battery_range_m, 0.0, 100.0);
    }
    /// Returns the distance that can be flown before the reserve is needed: range - reserve - flown - beeline home.
    /// Negative means that the way home already needs the reserve.
    double rangeLeft_m(double beeline_home_m, const Settings& settings) const {
        return usableRange_m(settings) - since_charge_m_ - beeline_home_m;
    }

private:
    std::optional<Vec3> last_m_; ///< place of the last move; nullopt before the first
    double since_charge_m_ = 0.0;
    double total_m_ = 0.0;
    int charges_ = 0;
};

/// What a robot has to fly until it stands at home.
struct WayHome {
    double beeline_m = 0.0;
    double height_m = 0.0;  ///< over the ground
    double speed_m_s = 1.0; ///< that it makes good against the wind
};

/// True if the robot's own battery may not last for the way home: 30 % longer than the beeline, the descent, and the
/// reserve. `left` is what the server last said; unknown is not low.
inline bool isLow(const std::optional<Seconds>& left, const WayHome& way, const Settings& settings) {
    const Seconds needed(1.3 * way.beeline_m / way.speed_m_s + way.height_m / settings.descent_speed_m_s +
                         settings.robot_battery_reserve_s);
    return left && *left < needed;
}

} // namespace usar::airrobot
