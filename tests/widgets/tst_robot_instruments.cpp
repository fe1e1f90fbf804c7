// The instruments of a robot, made from what it says: all shipped robots in both dialects of the embedded simulator,
// and single lines.
#include <QTest>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"
#include "widgets/models/robot_instruments.h"
#include "widgets/panels/instrument_panel.h"
#include "widgets/style/theme.h"

namespace tst_robot_instruments {

using namespace usar;
using namespace usar::widgets;

namespace {

/// A robot in the embedded simulator, and what its instruments heard of it.
struct Shipped {
    std::unique_ptr<sim::Simulation> simulation;
    sim::Talker talker;
    RobotInstruments instruments;
    Seconds now{0.0};

    Shipped(const std::string& class_name, protocol::Dialect profile)
        : simulation(sim::simulationOf(class_name == "Submarine" ? sim::lake() : sim::flatWorld(), options(profile)))
        , talker(*simulation) {
        const char* const height = class_name == "Submarine" ? "-31" : class_name == "AirRobot" ? "-4" : "-0.5";
        talker.say("INIT {ClassName USARBot." + class_name + "} {Name R1} {Location 0,0," + height + "}");
        hear(20);
    }
    static sim::SimulationOptions options(protocol::Dialect profile) {
        sim::SimulationOptions options;
        options.profile = profile;
        return options;
    }
    void hear(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            simulation->step();
            for (const protocol::InfoLine& line : talker.hear()) {
                if (const auto* state = std::get_if<protocol::RobotState>(&line.message))
                    now = state->time.value_or(now);
                instruments.take(line, now);
            }
        }
    }
    void ask() {
        for (const char* type : {"Robot", "Sonar", "RangeScanner", "Range", "Encoder", "MisPkg"})
            for (const char* question : {"GETGEO", "GETCONF"}) {
                talker.say(std::string(question) + " {Type " + type + "}");
                hear(1);
            }
    }
    QString figures() const {
        QStringList words;
        for (const InstrumentFigure& one : instruments.figures(now))
            words << one.caption;
        return words.join(", ");
    }
    QString lists() const {
        QStringList words;
        for (const ReadingList& one : instruments.lists())
            words << QStringLiteral("%1 %2").arg(one.title).arg(one.rows.size());
        words.sort();
        return words.join(", ");
    }
};

/// Instruments that heard these lines, all at `now`.
RobotInstruments after(const QStringList& lines, Seconds now = Seconds(100.0)) {
    protocol::Reader reader;
    RobotInstruments instruments;
    for (const QString& line : lines)
        instruments.take(reader.read(line.toStdString()), now);
    return instruments;
}

QString valueOf(const RobotInstruments& instruments, const QString& caption, Seconds now = Seconds(100.0)) {
    for (const InstrumentFigure& one : instruments.figures(now))
        if (one.caption == caption)
            return one.value;
    return QStringLiteral("no such figure");
}

const QString copter = QStringLiteral("STA {Type AerialVehicle} {Time 100} {Battery 1200}");
const QString diver = QStringLiteral("STA {Type NauticVehicle} {Time 100} {Battery 1200}");
const QString front_sonar = QStringLiteral("SEN {Time 100} {Type Sonar} {Name F1 Range 2.5} {Name F2 Range 5.0}");
const QString sonar_places =
    QStringLiteral("GEO {Type Sonar} {Name F1 Location 0.2,-0.1,0 Orientation 0,0,-0.5 Mount HARD} {Name F2 Location "
                   "0.2,0.1,0 Orientation 0,0,0.5 Mount HARD}");

} // namespace

class tst_RobotInstruments : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void aRobotGetsWhatItHas_data();
    void aRobotGetsWhatItHas();
    void aRobotThatSaysNothingHasNone();
    void readingsBecomeRows_data();
    void readingsBecomeRows();
    void aJointLiesInItsRange();
    void heightIsUprightEvenIfTheRobotLeans();
    void depthNeedsTheWater();
    void speedIsThatOfTheLastSecond();
    void theFreshSourceOfAttitudeWins();
    void rangesOfTheServerAreUsed();
    void sonarsLieWhereTheyAreMounted();
    void oneSilentSonarHasNoNumber();
    void silenceMakesStale_data();
    void silenceMakesStale();
    void aSlowSensorIsNotStaleTooSoon();
    void aDamagedTimeKeepsNothingFresh();
    void thePanelShowsThisRobotAndNoOther();
    void thePanelSaysWhyItIsEmpty();
    void figuresAreReadWithTheirUnits();
    void attitudeIsSaidInWords_data();
    void attitudeIsSaidInWords();
    void theHorizonLeansAgainstTheRobot();
    void nothingStaleIsColored();
};

void tst_RobotInstruments::aRobotGetsWhatItHas_data() {
    QTest::addColumn<QString>("figures");
    QTest::addColumn<QString>("lists");
    QTest::addColumn<QString>("attitude");
    QTest::addColumn<bool>("scans");
    QTest::addColumn<bool>("ground");
    QTest::addColumn<int>("cones");
    const QString rover = "CameraPanTilt 2, GPS 4, encoders 4, victims 1";
    QTest::newRow("AirRobot") << "over start, over ground, speed, climb"
                              << ""
                              << "INS" << true << true << 9;
    QTest::newRow("P2DX") << "over start, speed" << rover << "INS" << true << false << 8;
    QTest::newRow("P2AT") << "over start, speed" << rover << "INS" << true << false << 8;
    QTest::newRow("Submarine") << "depth, over start, to bottom, speed, climb"
                               << "CameraPanTilt 2, joints 2"
                               << "GroundTruth" << false << false << 0;
    QTest::newRow("ERS") << "over start, speed"
                         << "ball 2, joints 15, touch 5"
                         << "INS" << false << false << 0;
}

void tst_RobotInstruments::aRobotGetsWhatItHas() {
    QFETCH(bool, scans);
    QFETCH(int, cones);
    for (const protocol::Dialect profile : {protocol::Dialect::Ut2004, protocol::Dialect::Udk}) {
        Shipped robot(QTest::currentDataTag(), profile);
        robot.instruments.setWater(30.0);
        robot.ask();
        QTEST(robot.figures(), "figures");
        QFETCH(QString, lists);
        if (profile == protocol::Dialect::Udk) // which has no such classes
            lists.remove(", victims 1").remove("ball 2, ");
        QCOMPARE(robot.lists(), lists);
        const PoseSource* const attitude = robot.instruments.pose().attitude(robot.now);
        QVERIFY(attitude && !attitude->heard.stale(robot.now));
        QTEST(QString::fromStdString(attitude->type), "attitude");
        QCOMPARE(robot.instruments.scan() != nullptr, scans);
        if (scans)
            QTEST(robot.instruments.scansGround(), "ground");
        const agent::SonarZones sonars = robot.instruments.sonars(robot.now);
        QCOMPARE(int(sonars.zones.size()), cones);
        QCOMPARE(int(robot.instruments.ring(sonars).cones.size()), cones);
        for (const ReadingList& list : robot.instruments.lists())
            QVERIFY2(!list.stale(robot.now) && !list.help.isEmpty(), qPrintable(list.title));
    }
}

void tst_RobotInstruments::aRobotThatSaysNothingHasNone() {
    const RobotInstruments station = after({"STA {Type StaticPlatform} {Time 100} {Battery 1200}"});
    QVERIFY(station.empty());
    QVERIFY(!station.settled(Seconds(100.5)));
    QVERIFY(station.settled(Seconds(101.5)));
    QVERIFY(station.figures(Seconds(101.5)).empty());
    QVERIFY(station.sonars(Seconds(101.5)).zones.empty());
}

void tst_RobotInstruments::readingsBecomeRows_data() {
    QTest::addColumn<QStringList>("lines");
    QTest::addColumn<QString>("rows");
    QTest::newRow("UT2004 encoders") << QStringList{"SEN {Type Encoder} {Name ECLeft Tick -31} {Name ECRight Tick -18}"}
                                     << "ECLeft −31 ticks; ECRight −18 ticks";
    QTest::newRow("UDK encoders, a line each") << QStringList{"SEN {Time 52.6} {Type Encoder} {Name W1} {Tick 14}",
                                                              "SEN {Time 52.6} {Type Encoder} {Name W2} {Tick 7}"}
                                               << "W1 14 ticks; W2 7 ticks";
    QTest::newRow("encoders of a known size")
        << QStringList{"CONF {Type Encoder} {Name L} {Resolution 0.0174533}", "SEN {Type Encoder} {Name L Tick 90}"}
        << "L 90 ticks = 90°";
    QTest::newRow("touch") << QStringList{"SEN {Type Touch} {Name L Touch False} {Name R Touch True}"}
                           << "L free; R touched";
    QTest::newRow("ranges") << QStringList{"SEN {Time 66} {Type IR} {Name IR1 Range 0.4122} {Name IR2 Range 0.8000}"}
                            << "IR1 0.41 m; IR2 0.80 m";
    QTest::newRow("a ray that looks down is a figure instead")
        << QStringList{"SEN {Time 66} {Type Range} {Name Laser Range 3.5}",
                       "GEO {Type Range} {Name Laser Location 0,0,0.1 Orientation 0,-1.5707,0 Mount HARD}"}
        << "";
    QTest::newRow("ball in sight") << QStringList{"SEN {Time 67.2} {Type Helper} {Name b} {Pos3D 3,4,0} {Visible true}"}
                                   << "in sight yes; distance 5.00 m";
    QTest::newRow("ball out of sight")
        << QStringList{"SEN {Time 67.2} {Type Helper} {Name b} {Pos3D 3,4,0} {Visible false}"}
        << "in sight no; distance – m";
    QTest::newRow("victims") << QStringList{"SEN {Time 1} {Type VictSensor} {Name V} {PartName Leg} {Location 3,4,0}"}
                             << "Leg 5.00 m, 53° right";
    QTest::newRow("no victims") << QStringList{"SEN {Time 1} {Type VictSensor} {Name V} {Status NoVictims}"}
                                << "in view nobody";
    QTest::newRow("a victim that has gone is gone")
        << QStringList{"SEN {Time 1} {Type VictSensor} {Name V} {PartName Leg} {Location 3,4,0}",
                       "SEN {Time 2} {Type VictSensor} {Name V} {Status NoVictims}"}
        << "in view nobody";
    QTest::newRow("tags")
        << QStringList{"SEN {Time 8} {Type RFID} {Name R} {ID 21} {Location 2,0,0} {Mem seen} {ID 22}"}
        << "tag 21 2.00 m, ahead · seen; tag 22 in reach";
    QTest::newRow("gas") << QStringList{"SEN {Time 1} {Type CO2Sensor} {Name C} {Gas CO2} {Density 0.25}"}
                         << "CO2 0.25";
    QTest::newRow("wheels") << QStringList{"SEN {Time 48} {Type Tachometer} {Name T} {Vel 0.5,-0.25} {Pos 1,2}"}
                            << "wheel 1 0.50 rad/s; wheel 2 −0.25 rad/s";
    QTest::newRow("legs") << QStringList{"STA {Type LeggedRobot} {Time 3.80} {LFLeg1 -1.5708} {Battery 1197}"}
                          << "LFLeg1 −90.0 °";
    QTest::newRow("a UDK arm") << QStringList{"ASTA {Time 1} {Name Arm} {Link 1} {Value 0.5236}"} << "joint 1 30.0 °";
    QTest::newRow("an unknown sensor") << QStringList{"SEN {Time 1} {Type Geiger} {Name G} {Dose 0.25}"} << "";
}

void tst_RobotInstruments::readingsBecomeRows() {
    QFETCH(QStringList, lines);
    QStringList rows;
    const RobotInstruments instruments = after(lines);
    for (const ReadingList& list : instruments.lists())
        for (const ReadingRow& row : list.rows)
            rows << row.text();
    QTEST(rows.join("; "), "rows");
}

void tst_RobotInstruments::aJointLiesInItsRange() {
    const QString state = "MISSTA {Time 1} {Name Cam} {Link 1} {Value 0.5} {Torque -20.00} {Link 2} {Value 0.25}";
    const QString limits = "CONF {Type MisPkg} {Name Cam} {Link 1} {JointType Revolute} {MinRange -1.0} {MaxRange 1.0} "
                           "{Link 2} {JointType Prismatic} {MinRange 0.0} {MaxRange 0.5}";
    const RobotInstruments known = after({limits, state});
    const auto& rows = known.lists().at(0).rows;
    QVERIFY(rows[0].share && std::abs(*rows[0].share - 0.75) < 1e-9);
    QCOMPARE(rows[0].zero_share, std::optional(0.5));
    QCOMPARE(rows[1].share, std::optional(0.5));
    QCOMPARE(rows[1].text(), QStringLiteral("joint 2 0.250 m"));
    const RobotInstruments unknown = after({state});
    QVERIFY(std::abs(*unknown.lists().at(0).rows[0].share - (0.5 + 0.5 / (2.0 * pi))) < 1e-9);
}

void tst_RobotInstruments::heightIsUprightEvenIfTheRobotLeans() {
    const QString scan = "SEN {Time 100} {Type RangeScanner} {Name S} {Resolution 0.01} {FOV 0.02} {Range 5,5,5}";
    const QString lean = "SEN {Type INS} {Name INS} {Location 0,0,-6} {Orientation 1.0472,0,0}"; // 60 degrees
    QCOMPARE(valueOf(after({copter, scan}), "over ground"), QStringLiteral("5.00"));
    QCOMPARE(valueOf(after({copter, scan, lean}), "over ground"), QStringLiteral("2.50"));
    QString far = scan;
    far.replace("5,5,5", "20,20,20"); // The usual range of a scanner: nothing in reach.
    QCOMPARE(valueOf(after({copter, far}), "over ground"), QStringLiteral("–"));
}

void tst_RobotInstruments::depthNeedsTheWater() {
    RobotInstruments robot =
        after({diver, "SEN {Time 100} {Type GroundTruth} {Name GT} {Location 0,0,3.5} {Orientation 0,0,0}"});
    QCOMPARE(valueOf(robot, "depth"), QStringLiteral("no such figure"));
    robot.setWater(1.5);
    QCOMPARE(valueOf(robot, "depth"), QStringLiteral("5.00"));
}

void tst_RobotInstruments::speedIsThatOfTheLastSecond() {
    protocol::Reader reader;
    RobotInstruments robot;
    robot.take(reader.read(copter.toStdString()), Seconds(100.0));
    for (int i = 0; i <= 20; ++i) { // Two meters per second ahead, and half a meter per second up.
        const double s = 100.0 + 0.1 * i;
        const QString line = QStringLiteral("SEN {Time %1} {Type GroundTruth} {Name G} {Location %2,0,%3} "
                                            "{Orientation 0,0,0}")
                                 .arg(s)
                                 .arg(0.2 * i)
                                 .arg(-0.05 * i);
        robot.take(reader.read(line.toStdString()), Seconds(s));
        if (i == 0)
            QCOMPARE(valueOf(robot, "speed"), QStringLiteral("–"));
    }
    QCOMPARE(valueOf(robot, "speed", Seconds(102.0)), QStringLiteral("2.00"));
    QCOMPARE(valueOf(robot, "climb", Seconds(102.0)), QStringLiteral("0.50"));
    QCOMPARE(valueOf(robot, "over start", Seconds(102.0)), QStringLiteral("1.00"));
}

void tst_RobotInstruments::theFreshSourceOfAttitudeWins() {
    protocol::Reader reader;
    RobotInstruments robot;
    const auto hear = [&](const char* line, double s) { robot.take(reader.read(line), Seconds(s)); };
    hear("STA {Type AerialVehicle} {Time 100}", 100.0);
    hear("SEN {Time 100} {Type IMU} {Name I} {Rotation 0,0,1}", 100.0);
    QCOMPARE(robot.pose().attitude(Seconds(100.0))->type, std::string("IMU"));
    hear("SEN {Type INS} {Name INS} {Location 0,0,-6} {Orientation 0,0,0}", 100.0);
    QCOMPARE(robot.pose().attitude(Seconds(100.0))->type, std::string("INS"));
    hear("SEN {Time 103} {Type IMU} {Name I} {Rotation 0,0,1}", 103.0);
    QCOMPARE(robot.pose().attitude(Seconds(103.0))->type, std::string("IMU"));
    QVERIFY(robot.pose().attitude(Seconds(200.0))->heard.stale(Seconds(200.0)));
}

void tst_RobotInstruments::rangesOfTheServerAreUsed() {
    const QString scan = "SEN {Time 100} {Type RangeScanner} {Name S} {Resolution 0.01} {FOV 0.02} {Range 5,5,5}";
    QCOMPARE(after({scan}).scanMaximum_m(), 20.0);
    QCOMPARE(after({scan, "CONF {Type RangeScanner} {Name S} {MaxRange 30.0}"}).scanMaximum_m(), 30.0);
    QVERIFY(after({copter, scan}).scansGround());
    QVERIFY(!after({copter, scan, "GEO {Type RangeScanner} {Name S Location 0,0,0 Orientation 0,0,0 Mount HARD}"})
                 .scansGround());
    const agent::SonarZones zones =
        after({front_sonar, "CONF {Type Sonar} {Name f1} {MaxRange 3.0} {BeamAngle 0.3}"}).sonars(Seconds(100.0));
    QCOMPARE(zones.zones[0].maximum_m, 3.0);
    QCOMPARE(zones.zones[1].maximum_m, 5.0);
}

void tst_RobotInstruments::sonarsLieWhereTheyAreMounted() {
    const RobotInstruments robot =
        after({front_sonar, sonar_places, "CONF {Type Sonar} {Name F1} {MaxRange 5.0} {BeamAngle 0.3}"});
    agent::SonarZones zones = robot.sonars(Seconds(100.0));
    zones.zones[0].risk = agent::Risk::High;
    const SonarRing ring = robot.ring(zones);
    QCOMPARE(ring.cones.size(), std::size_t(2));
    const SonarCone& left = ring.cones[0]; // y is to the right on the wire.
    QCOMPARE(left.name, std::string("F1"));
    QVERIFY((left.at_m - Vec2(0.2, 0.1)).norm() < 1e-9 && std::abs(left.bearing_rad - 0.5) < 1e-9);
    QVERIFY(std::abs(left.half_angle_rad - 0.15) < 1e-9 && left.risk == agent::Risk::High);
    QVERIFY(after({front_sonar}).ring(zones).cones.empty()); // Nobody told where they are.
    const QString down = "GEO {Type Sonar} {Name F1 Location 0,0,0 Orientation 0,-1.5707,0 Mount HARD}";
    const RobotInstruments belly = after({copter, down, front_sonar});
    QVERIFY(belly.ring(belly.sonars(Seconds(100.0))).cones.empty());
    QCOMPARE(valueOf(belly, "over ground"), QStringLiteral("2.50"));
}

void tst_RobotInstruments::oneSilentSonarHasNoNumber() {
    protocol::Reader reader;
    RobotInstruments robot;
    for (double s = 100.0; s < 105.0; s += 0.1) {
        const std::string time = std::to_string(s);
        robot.take(reader.read("SEN {Time " + time + "} {Type Sonar} {Name F1} {Range 2.5}"), Seconds(s));
        if (s < 101.0)
            robot.take(reader.read("SEN {Time " + time + "} {Type Sonar} {Name F2} {Range 3.5}"), Seconds(s));
    }
    const agent::SonarZones zones = robot.sonars(Seconds(105.0));
    QCOMPARE(zones.zones[0].range_m, 2.5);
    QVERIFY(std::isnan(zones.zones[1].range_m));
    QCOMPARE(robot.sonars(Seconds(200.0)).zones[1].range_m, 3.5); // All are stale; the whole instrument says so.
}

void tst_RobotInstruments::silenceMakesStale_data() {
    QTest::addColumn<QString>("robot_class");
    for (const char* name : {"AirRobot", "P2DX", "P2AT", "Submarine", "ERS"})
        QTest::newRow(name) << QString(name);
}

void tst_RobotInstruments::silenceMakesStale() {
    QFETCH(QString, robot_class);
    Shipped robot(robot_class.toStdString(), protocol::Dialect::Ut2004);
    robot.ask();
    InstrumentPanel panel;
    panel.showRobot(robot.instruments, robot.now, true);
    const auto views = [&panel] {
        std::vector<Instrument*> shown;
        for (QWidget* child : panel.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
            if (auto* one = dynamic_cast<Instrument*>(child); one && !one->isHidden() && one != panel.terrain())
                shown.push_back(one);
        return shown;
    };
    QVERIFY(views().size() >= 3);
    for (const Instrument* view : views())
        QVERIFY2(!view->stale(), qPrintable(view->accessibleName()));
    panel.showRobot(robot.instruments, robot.now, false); // The robot is silent.
    for (const Instrument* view : views())
        QVERIFY2(view->stale(), qPrintable(view->accessibleName()));
    panel.showRobot(robot.instruments, robot.now, true);
    for (const Instrument* view : views())
        QVERIFY2(!view->stale(), qPrintable(view->accessibleName()));
    panel.showRobot(robot.instruments, robot.now + Seconds(7.0), true); // It goes on, but its sensors do not.
    for (const Instrument* view : views()) {
        QVERIFY2(view->stale(), qPrintable(view->accessibleName()));
        QVERIFY2(view->accessibleDescription().contains("out of date, ") &&
                     view->accessibleDescription().endsWith(" s old"),
                 qPrintable(view->accessibleDescription()));
    }
}

void tst_RobotInstruments::aSlowSensorIsNotStaleTooSoon() {
    protocol::Reader reader;
    RobotInstruments robot;
    for (int s = 100; s <= 110; s += 2) // A line every two seconds.
        robot.take(reader.read("SEN {Time " + std::to_string(s) + "} {Type Encoder} {Name L} {Tick 1}"), Seconds(s));
    const ReadingList& list = robot.lists().at(0);
    QVERIFY(!list.stale(Seconds(115.0)));
    QVERIFY(list.stale(Seconds(117.0)));
}

void tst_RobotInstruments::aDamagedTimeKeepsNothingFresh() {
    RobotInstruments robot = after({"SEN {Time 99999} {Type Encoder} {Name L} {Tick 1}"});
    QVERIFY(robot.lists().at(0).stale(Seconds(102.0)));
}

void tst_RobotInstruments::thePanelShowsThisRobotAndNoOther() {
    InstrumentPanel panel;
    Shipped copter_robot("AirRobot", protocol::Dialect::Ut2004);
    Shipped walker("ERS", protocol::Dialect::Ut2004);
    panel.showRobot(copter_robot.instruments, copter_robot.now, true);
    QVERIFY(!panel.laser()->isHidden() && !panel.sonars()->isHidden() && panel.ring()->isHidden());
    QVERIFY(panel.lists().empty());
    copter_robot.ask();
    panel.showRobot(copter_robot.instruments, copter_robot.now, true);
    QVERIFY(!panel.ring()->isHidden());
    panel.showRobot(walker.instruments, walker.now, true);
    QVERIFY(panel.laser()->isHidden() && panel.sonars()->isHidden() && panel.ring()->isHidden());
    QCOMPARE(panel.lists().size(), std::size_t(3));
    QCOMPARE(panel.figures().join(" "), QStringLiteral("over start speed"));
    panel.showRobot(copter_robot.instruments, copter_robot.now, true);
    QVERIFY(!panel.laser()->isHidden() && panel.lists().empty());
    panel.clear();
    QVERIFY(panel.laser()->isHidden() && panel.figures().isEmpty());
}

void tst_RobotInstruments::thePanelSaysWhyItIsEmpty() {
    InstrumentPanel panel;
    QVERIFY(panel.emptyWords().contains("No robot"));
    const RobotInstruments station = after({"STA {Type StaticPlatform} {Time 100} {Battery 1200}"});
    panel.showRobot(station, Seconds(100.5), true);
    QVERIFY(panel.emptyWords().contains("Waiting"));
    panel.showRobot(station, Seconds(102.0), true);
    QVERIFY(panel.emptyWords().contains("no reading"));
    panel.showRobot(after({front_sonar}), Seconds(100.0), true);
    QVERIFY(panel.emptyWords().isEmpty());
}

void tst_RobotInstruments::figuresAreReadWithTheirUnits() {
    InstrumentPanel panel;
    Shipped diver_robot("Submarine", protocol::Dialect::Ut2004);
    diver_robot.instruments.setWater(30.0);
    diver_robot.ask();
    panel.showRobot(diver_robot.instruments, diver_robot.now, true);
    for (const QString& caption : panel.figures())
        for (const Readout* readout : panel.findChildren<Readout*>())
            if (readout->accessibleName() == caption) {
                QVERIFY2(readout->accessibleDescription().contains(" m"), qPrintable(caption));
                QVERIFY2(readout->toolTip().contains("meters"), qPrintable(caption));
            }
    QVERIFY(panel.attitude()->accessibleDescription().contains("by GroundTruth"));
    const auto lists = panel.lists();
    const auto camera = std::ranges::find(lists, QStringLiteral("CameraPanTilt"), &QWidget::accessibleName);
    QVERIFY(camera != lists.end());
    QVERIFY2((*camera)->accessibleDescription().contains("joint 1 0.0 °"),
             qPrintable((*camera)->accessibleDescription()));
    panel.showRobot(after({front_sonar, sonar_places}), Seconds(100.0), true);
    QCOMPARE(panel.ring()->accessibleDescription(), QStringLiteral("F1 2.50 m, F2 5.00 m"));
    QVERIFY(panel.ring()->toolTip().contains("up to 5.0 m"));
}

void tst_RobotInstruments::attitudeIsSaidInWords_data() {
    QTest::addColumn<double>("roll_deg");
    QTest::addColumn<double>("pitch_deg");
    QTest::addColumn<double>("yaw_deg");
    QTest::addColumn<QString>("words");
    QTest::newRow("level") << 0.2 << -0.3 << 0.0 << "roll level, pitch level, yaw 0°, by INS";
    QTest::newRow("right side down, nose up") << 10.0 << -5.0 << 90.0 << "roll 10° right, pitch 5° up, yaw 90°, by INS";
    QTest::newRow("left side down, nose down")
        << -10.0 << 5.0 << 270.0 << "roll 10° left, pitch 5° down, yaw −90°, by INS";
}

void tst_RobotInstruments::attitudeIsSaidInWords() {
    QFETCH(double, roll_deg);
    QFETCH(double, pitch_deg);
    QFETCH(double, yaw_deg);
    AttitudeView view;
    view.setAttitude({radians(roll_deg), radians(pitch_deg), radians(yaw_deg)}, "INS");
    QTEST(view.accessibleDescription(), "words");
}

namespace {

/// The share of the horizon's disc, in this half of it, that has the color of the ground.
double groundShare(AttitudeView& view, bool left_half) {
    const QImage image = view.grab().toImage();
    int ground = 0;
    int all = 0;
    for (int y = 40; y < 110; ++y)
        for (int x = left_half ? 45 : 80; x < (left_half ? 70 : 105); ++x) {
            const QColor c = image.pixelColor(x, y);
            ground += c.red() > c.blue() + 20 ? 1 : 0;
            ++all;
        }
    return double(ground) / all;
}

} // namespace

void tst_RobotInstruments::theHorizonLeansAgainstTheRobot() {
    AttitudeView view;
    view.resize(300, 160);
    view.setAttitude({0.0, 0.0, 0.0}, "INS");
    const double level = groundShare(view, true);
    QVERIFY(level > 0.3 && level < 0.7);
    view.setAttitude({0.0, radians(20.0), 0.0}, "INS"); // Nose down: more ground.
    QVERIFY(groundShare(view, true) > level + 0.1);
    view.setAttitude({0.0, radians(-20.0), 0.0}, "INS");
    QVERIFY(groundShare(view, true) < level - 0.1);
    view.setAttitude({radians(40.0), 0.0, 0.0}, "INS"); // Right side down: the ground rises there.
    QVERIFY(groundShare(view, false) > groundShare(view, true) + 0.2);
}

void tst_RobotInstruments::nothingStaleIsColored() {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        applyTheme(theme);
        SonarRingView ring;
        ring.resize(300, 200);
        const RobotInstruments robot = after({front_sonar, sonar_places});
        agent::SonarZones zones = robot.sonars(Seconds(100.0));
        zones.zones[0].risk = agent::Risk::High;
        ring.setRing(robot.ring(zones));
        const auto reds = [&ring] {
            const QImage image = ring.grab().toImage();
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += image.pixelColor(x, y).red() > image.pixelColor(x, y).green() + 60 ? 1 : 0;
            return count;
        };
        QVERIFY(reds() > 5);
        ring.setStale(true, Seconds(12.0));
        QCOMPARE(reds(), 0);
        QVERIFY(ring.accessibleDescription().endsWith("out of date, 12 s old"));
    }
    applyTheme(Theme::Dark);
}

USAR_TEST(tst_RobotInstruments)

} // namespace tst_robot_instruments

#include "tst_robot_instruments.moc"
