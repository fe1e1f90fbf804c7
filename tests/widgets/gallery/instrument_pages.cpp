#include <cmath>

#include <QVBoxLayout>

#include "core/protocol/reader.h"
#include "tests/widgets/gallery/pages.h"
#include "widgets/panels/instrument_panel.h"
#include "widgets/panels/sensor_panel.h"
#include "widgets/panels/status_strip.h"
#include "widgets/style/theme.h"

namespace usar::gallery {

using namespace usar::widgets;

namespace {

protocol::RangeScan roughGround() {
    protocol::RangeScan scan;
    scan.resolution_rad = radians(1.0);
    scan.fov_rad = radians(180.0);
    for (std::size_t i = 0; i < 181; ++i) {
        scan.ranges_m.push_back(20.0);
        const double a = scan.beamAngle_rad(i);
        for (double r = 0.5; r < 20.0; r += 0.05)
            if (r * std::cos(a) > 6.0 + 0.8 * std::sin(r * std::sin(a) * 0.9) + 0.2 * std::sin(r * std::sin(a) * 4.0)) {
                scan.ranges_m.back() = r;
                break;
            }
    }
    return scan;
}

/// Mapped behind the robot and a little ahead.
mapping::CourseProfile roughCourse() {
    mapping::CourseProfile profile{{}, 20.0, 6.3};
    for (double d = -20.0; d <= 20.0; d += 0.25)
        profile.points.push_back(
            {d, d < 3.0 ? std::optional(float(0.8 * std::sin(0.5 * d) + 0.3 * std::sin(2.1 * d))) : std::nullopt});
    return profile;
}

agent::SonarZones zones() {
    const double ranges[] = {5.0, 5.0, 4.3, 3.1, 4.95, 5.0, 5.0, 5.0, 4.99};
    const double low[] = {4.2, 4.4, 4.6, 4.8, 4.98, 4.8, 4.6, 4.4, 4.2};
    const char* names[] = {"L4", "L3", "L2", "L1", "M0", "R1", "R2", "R3", "R4"};
    agent::SonarZones zones;
    for (int i = 0; i < 9; ++i) {
        const double high = low[i] - 0.2;
        const auto risk = ranges[i] < high     ? agent::Risk::High
                          : ranges[i] < low[i] ? agent::Risk::Low
                                               : agent::Risk::None;
        zones.zones.push_back({names[i], 0.0, ranges[i], 5.0, low[i], high, risk});
    }
    return zones;
}

} // namespace

std::unique_ptr<QWidget> instrumentsPage() {
    auto page = std::make_unique<QWidget>();
    page->resize(640, 560);
    auto* row = new QHBoxLayout(page.get());
    for (const bool live : {true, false}) {
        auto* column = new QVBoxLayout;
        auto* strip = new StatusStrip;
        auto* fan = new LaserFanView;
        auto* terrain = new TerrainProfileView;
        auto* sonars = new SonarColumnsView;
        if (live) {
            strip->setStatus({Seconds(751.0), Seconds(751.0), "scanning lane 4 of 9", 38.0, 72.0, 412.0, 42.0,
                              Seconds(980.0), 1204.0, 1, false, TimeRange{Seconds(900.0), Seconds(1080.0)}});
            strip->setBattery(28.0);
            fan->setScan(roughGround());
            terrain->setProfile(roughCourse());
            sonars->setZones(zones());
        }
        column->addWidget(strip);
        column->addWidget(fan, 3);
        column->addWidget(terrain, 2);
        column->addWidget(sonars, 2);
        row->addLayout(column, 1);
    }
    return page;
}

std::unique_ptr<QWidget> robotInstrumentsPage() {
    auto page = std::make_unique<QWidget>();
    page->resize(680, 900);
    auto* row = new QHBoxLayout(page.get());
    const char* const lines[] = {
        "STA {Type GroundVehicle} {Time 12.05} {FRFlipper -0.6106} {FLFlipper 1.1005} {Battery 1188}",
        "GEO {Type GroundVehicle} {Name P2DX} {Dimensions 0.4400,0.3800,0.2200} {COG 0,0,0} {WheelRadius 0.0820}",
        "GEO {Type Sonar} {Name F1 Location 0.11,-0.13,0 Orientation 0,0,-1.57 Mount HARD} {Name F2 Location "
        "0.19,-0.08,0 Orientation 0,0,-0.52 Mount HARD} {Name F3 Location 0.19,0.08,0 Orientation 0,0,0.52 Mount HARD} "
        "{Name F4 Location 0.11,0.13,0 Orientation 0,0,1.57 Mount HARD}",
        "CONF {Type Sonar} {Name F1} {MaxRange 5.0} {BeamAngle 0.349} {Name F2} {MaxRange 5.0} {BeamAngle 0.349} "
        "{Name F3} {MaxRange 5.0} {BeamAngle 0.349} {Name F4} {MaxRange 5.0} {BeamAngle 0.349}",
        "SEN {Time 12.05} {Type Sonar} {Name F1 Range 0.92} {Name F2 Range 3.31} {Name F3 Range 5.0} {Name F4 Range "
        "1.4}",
        "SEN {Type INS} {Name INS} {Location 4.50,-1.90,-3.80} {Orientation 0.2,0.15,0.9}",
        "SEN {Type Encoder} {Name ECLeft Tick -31} {Name ECRight Tick -18}",
        "SEN {Type Touch} {Name Left Touch False} {Name Right Touch True}",
        "SEN {Time 12} {Type VictSensor} {Name VictSensor} {PartName Arm} {Location 2.05,0.33,0.46}",
        "SEN {Time 12} {Type RFID} {Name RFID} {ID 21} {Location 3.04,4.52,0.23} {Mem seen by robot 2} {ID 22}",
    };
    RobotInstruments robot;
    protocol::Reader reader;
    for (const char* line : lines)
        robot.take(reader.read(line), Seconds(12.05));
    for (const double age_s : {0.0, 12.0}) {
        auto* panel = new InstrumentPanel;
        panel->status()->setAbilities(protocol::VehicleKind::Ground, false);
        panel->terrain()->hide();
        panel->showRobot(robot, Seconds(12.05 + age_s), true);
        row->addWidget(panel, 1);
    }
    return page;
}

std::unique_ptr<QWidget> sensorsPage() {
    auto panel = std::make_unique<SensorPanel>();
    panel->resize(380, 520);
    const auto take = [&](protocol::InfoMessage message, double now_s) {
        panel->take({{1}, {}, std::move(message), {}}, Seconds(now_s));
    };
    take(protocol::GameInfo{"USARBot.USARDeathMatch", "tall_test", 0}, 0.2);
    for (int i = 1; i < 30; ++i) {
        const double now_s = 0.2 * i;
        if (i < 12)
            take(protocol::SonarReadings{Seconds(now_s), {{"L1", 3.1}, {"M0", 4.95}, {"R1", 5.0}}}, now_s);
        take(protocol::InsReading{{}, "INS", {{31.24, -8.02, 6.31}, 0.01, -0.02, 1.57}}, now_s);
        take(protocol::RobotState{.kind = protocol::VehicleKind::Aerial,
                                  .time = Seconds(now_s),
                                  .battery_left = Seconds(1140)},
             now_s);
        panel->refresh();
    }
    return panel;
}

} // namespace usar::gallery
