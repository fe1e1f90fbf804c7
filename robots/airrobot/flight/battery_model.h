// The simulated battery of the thesis (4.1). The simulator cannot charge batteries, so the capacity is a distance.
#pragma once

#include "core/base/geometry.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// Adds up the distance flown since the last charge, according to the INS. Owned by one robot.
class BatteryModel {
public:
    /// Adds the distance from the last position. Ignores moves of a few centimeters, which are noise of the protocol
    /// while the robot stands still.
    void moveTo(const Vec3& position_in_map_m);
    /// Makes the next move start at its own position, because the position estimate has jumped.
    void forgetPosition() { has_position_ = false; }
    void recharge();

    double flownSinceCharge_m() const { return since_charge_m_; }
    /// The total distance flown.
    double flown_m() const { return total_m_; }
    /// The number of recharges.
    int charges() const { return charges_; }
    /// The used share of the battery's range, 0 to 100.
    double used_pct(const Settings& settings) const;
    /// Returns the distance that can be flown before the reserve is needed: range - reserve - flown - beeline home.
    /// Negative means that the way home already needs the reserve.
    double rangeLeft_m(double beeline_home_m, const Settings& settings) const;

private:
    Vec3 last_m_ = Vec3::Zero();
    bool has_position_ = false;
    double since_charge_m_ = 0.0;
    double total_m_ = 0.0;
    int charges_ = 0;
};

} // namespace usar::airrobot
