#include <algorithm>
#include <cmath>

#include "core/sim/sensors/motion_sensors.h"

namespace usar::sim {

namespace {

constexpr double meters_per_degree_north = 111'200.0;
constexpr double meters_per_degree_east = 71'670.0;
constexpr int satellites_in_sky = 12;
constexpr int satellites_for_fix = 4;
constexpr double worst_sigma_m = 0.83; ///< with four satellites
constexpr double best_sigma_m = 0.25;  ///< with all satellites
constexpr double satellite_m = 300.0;  ///< a satellite is hidden by anything within this distance

} // namespace

/// Spreads the satellites over the sky above 10 degrees by the golden angle.
GpsSensor::GpsSensor(const SensorModel& model, const SensorBirth& birth) : Sensor(model, birth) {
    for (int i = 0; i < satellites_in_sky; ++i) {
        const double elevation_rad = radians(10.0 + 75.0 * i / satellites_in_sky);
        const double azimuth_rad = i * pi * (3.0 - std::sqrt(5.0));
        satellites_.emplace_back(std::cos(elevation_rad) * std::cos(azimuth_rad),
                                 std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
    }
}

void GpsSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Vec3 at_m = sensor_in_map(view).translation();
    const auto seen = std::ranges::count_if(
        satellites_, [&](const Vec3& toward) { return view.rays.cast(at_m, toward, satellite_m) >= satellite_m; });
    protocol::GpsReading reading{.name = model().name, .fix = seen >= satellites_for_fix, .satellites = seen};
    if (reading.fix) {
        const double share = static_cast<double>(seen - satellites_for_fix) / (satellites_in_sky - satellites_for_fix);
        const double sigma_m = makesErrors() ? worst_sigma_m + share * (best_sigma_m - worst_sigma_m) : 0.0;
        const auto error_m = [&] { return sigma_m > 0.0 ? gaussian(random_, sigma_m) : 0.0; };
        // The map's x points north and its y west; the wire's y points east (protocol.md 3).
        reading.latitude_rad =
            radians(view.world.gps_reference.latitude_deg + (at_m.x() + error_m()) / meters_per_degree_north);
        reading.longitude_rad =
            radians(view.world.gps_reference.longitude_deg - (at_m.y() + error_m()) / meters_per_degree_east);
    }
    out.emplace_back(std::move(reading));
}

} // namespace usar::sim
