#include "robots/airrobot/flight/battery_model.h"

#include <algorithm>

namespace usar::airrobot {

namespace {
constexpr double smallest_move_m = 0.03;
}

void BatteryModel::moveTo(const Vec3& position_in_map_m) {
    if (!has_position_) {
        last_m_ = position_in_map_m;
        has_position_ = true;
        return;
    }
    const double move_m = (position_in_map_m - last_m_).norm();
    if (!(move_m >= smallest_move_m))
        return;
    since_charge_m_ += move_m;
    total_m_ += move_m;
    last_m_ = position_in_map_m;
}

void BatteryModel::recharge() {
    since_charge_m_ = 0.0;
    ++charges_;
}

double BatteryModel::used_pct(const Settings& settings) const {
    return std::clamp(100.0 * since_charge_m_ / settings.battery_range_m, 0.0, 100.0);
}

double BatteryModel::rangeLeft_m(double beeline_home_m, const Settings& settings) const {
    const double usable_m = settings.battery_range_m * (1.0 - settings.battery_reserve_pct / 100.0);
    return usable_m - since_charge_m_ - beeline_home_m;
}

} // namespace usar::airrobot
