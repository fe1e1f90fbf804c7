#include <cmath>

#include "core/base/geometry.h"
#include "core/protocol/reader.h"
#include "tests/widgets/gallery/pages.h"
#include "widgets/panels/parameter_form.h"
#include "widgets/panels/plot_view.h"

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
        {"yaw_rate_rad_s", "Largest yaw rate while scanning", "Flight", "rad/s", pi / 4, 0.0, 3.0, "", {}},
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

std::unique_ptr<QWidget> plotPage() {
    auto view = std::make_unique<PlotView>();
    view->resize(1100, 420);
    view->setRobot(QStringLiteral("R1"));
    for (const char* name : {"SEN Sonar/F1/range", "SEN Sonar/F2/range", "SEN GroundTruth/Truth/yaw"})
        view->addSeries(QString::fromLatin1(name));
    protocol::Reader reader;
    for (int i = 0; i < 400; ++i) {
        const double t = 700.0 + i * 0.2;
        const QString sonar = QStringLiteral("SEN {Time %1} {Type Sonar} {Name F1 Range %2} {Name F2 Range %3}")
                                  .arg(t)
                                  .arg(i % 90 > 80 ? QStringLiteral("nan") : QString::number(3.0 + std::sin(i * 0.05)))
                                  .arg(2.0 + std::cos(i * 0.07) * 0.7);
        const QString truth = QStringLiteral("SEN {Time %1} {Type GroundTruth} {Name Truth} {Location 1,2,3} "
                                             "{Orientation 0,0,%2}")
                                  .arg(t)
                                  .arg(std::sin(i * 0.02));
        view->take(QStringLiteral("R1"), reader.read(sonar.toStdString()), Seconds(t));
        view->take(QStringLiteral("R1"), reader.read(truth.toStdString()), Seconds(t));
    }
    view->addCanvas();
    view->addSeries(QStringLiteral("SEN Sonar/F2/range"));
    return view;
}

std::unique_ptr<QWidget> emptyPlotPage() {
    auto view = std::make_unique<PlotView>();
    view->resize(640, 240);
    return view;
}

} // namespace usar::gallery
