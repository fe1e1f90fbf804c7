#include "core/base/geometry.h"
#include "tests/widgets/gallery/pages.h"
#include "widgets/parameter_form.h"

namespace usar::gallery {

using namespace usar::widgets;

std::unique_ptr<QWidget> parametersPage() {
    auto form = std::make_unique<ParameterForm>();
    form->resize(280, 420);
    form->setSpecs({
        {"scan_altitude_m",
         "Scan altitude",
         "Flight",
         "m",
         6.0,
         2.0,
         40.0,
         "Height over the ground while scanning.",
         {}},
        {"scan_speed_m_s", "Scan speed", "Flight", "m/s", 2.5, 0.1, 5.0, "Speed along a lane.", {}},
        {"yaw_rate_rad_s",
         "Largest yaw rate while scanning",
         "Flight",
         "rad/s",
         pi / 4,
         0.0,
         3.0,
         "",
         {}},
        {"tilt_rad", "Tilt limit", "Flight", "rad", pi / 6, 0.0, 1.0, "", {}},
        {"reserve_pct", "Battery reserve", "Battery", "%", 15.0, 0.0, 90.0, "Kept for the way home.", {}},
        {"recharge", "Recharge and resume", "Battery", "", true, 0.0, 0.0, "Land at the start to recharge.", {}},
        {"sweep", "Sweep", "Coverage", "", std::string("longer side"), 0.0, 0.0, "", {"longer side", "shorter side"}},
        {"lanes", "Lanes at most", "Coverage", "", 200LL, 1.0, 1000.0, "", {}},
        {"name", "Name of the scan", "Coverage", "", std::string("scan"), 0.0, 0.0, "Begins the file names.", {}},
    });
    form->setValues({{"scan_altitude_m", 8.5}, {"recharge", false}, {"yaw_rate_rad_s", 1.0}});
    return form;
}

} // namespace usar::gallery
