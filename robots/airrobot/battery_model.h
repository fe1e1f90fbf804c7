// The simulated battery of the thesis (4.1): the simulator cannot charge, so capacity is a distance of our own.
#pragma once

#include "core/base/geometry.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// Counts the way flown since the last charge, by the INS. Owned by one robot.
class BatteryModel {
public:
    /// Moves shorter than the wire's centimetre noise while standing still add nothing.
    void moveTo(const Vec3& position_in_map_m);
    /// The estimate has jumped: the next move starts at the new place.
    void forgetPosition() { has_position_ = false; }
    void recharge();

    double flownSinceCharge_m() const { return since_charge_m_; }
    double flown_m() const { return total_m_; }
    int charges() const { return charges_; }
    double used_pct(const Settings& settings) const;
    /// Before the reserve is touched: range - reserve - flown - beeline home. Negative: too late to turn back calmly.
    double rangeLeft_m(double beeline_home_m, const Settings& settings) const;

private:
    Vec3 last_m_ = Vec3::Zero();
    bool has_position_ = false;
    double since_charge_m_ = 0.0;
    double total_m_ = 0.0;
    int charges_ = 0;
};

} // namespace usar::airrobot
