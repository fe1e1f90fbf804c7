// Every class name that the sources attest (protocol.md 2.4): it spawns, speaks, answers, and drives; or it is refused
// so that a person sees it.
#include <cmath>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTest>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_class_names {

using namespace usar;
using namespace usar::sim;

namespace {

SimulationOptions optionsOf(protocol::Dialect profile) {
    SimulationOptions options;
    options.profile = profile;
    return options;
}

struct Spawned {
    std::unique_ptr<Simulation> simulation;
    Talker talker;

    explicit Spawned(const std::string& class_name, protocol::Dialect profile = protocol::Dialect::Ut2004,
                     World world = flatWorld(), double z_m = 0.6)
        : simulation(simulationOf(std::move(world), optionsOf(profile)))
        , talker(*simulation) {
        talker.hearText();
        talker.say("INIT {ClassName USARBot." + class_name + "} {Name R1} {Location 0,0," + std::to_string(-z_m) + "}");
        steps(*simulation, 1);
    }
    RobotTruth truth() const { return simulation->robots().at(0); }
    QString answer(const std::string& question, const std::string& word) {
        talker.hearText();
        talker.say(question);
        steps(*simulation, 1);
        for (const std::string& line : talker.hearText())
            if (line.starts_with(word))
                return QString::fromStdString(line);
        return {};
    }
};

QString logOf(Simulation& simulation) {
    QStringList lines;
    for (const std::string& line : simulation.takeLog())
        lines << QString::fromStdString(line);
    return lines.join('\n');
}

} // namespace

class tst_ClassNames : public QObject {
    Q_OBJECT

private slots:
    void everyAttestedClassHasABody_data() {
        QTest::addColumn<QString>("body");
        const QList<QPair<QString, QString>> bodies{
            {"AirRobot", "AirRobot QuadRotor Passarola"},
            {"ATRVJr", "ATRVJr ATRV"},
            {"ERS", "ERS"},
            {"Kenaf", "Kenaf Tarantula Rugbot Soryu Crawler_Robot"},
            {"KR60", "KR60 KR6 Fanuc_M16iB20 KUKA_LWR_BOT"},
            {"OmniP2AT", "OmniP2AT OmniP2DX"},
            {"P2AT", "P2AT BasicSkidRobot Zerg Lisa Kurt2D Kurt3D"},
            {"P2DX", "P2DX P3DX CasterSkidRobot SegwayRMPFifty Kiva4Wheel"},
            {"P3AT", "P3AT pioneer3at_with_sensors pioneer3at_with_sensors_b"},
            {"Sedan", "Sedan Hummer Cooper SnowStorm ForkLift UnitLoader BasicAckermanRobot FrontAckerman"},
            {"StereoP2AT", "StereoP2AT"},
            {"Submarine", "Submarine"},
            {"Talon", "Talon Matilda Element"},
            {"TeleMax", "TeleMax"}};
        for (const auto& [body, names] : bodies)
            for (const QString& name : names.split(' '))
                QTest::newRow(qPrintable(name)) << body;
    }
    void everyAttestedClassHasABody() {
        QFETCH(const QString, body);
        const QString name = QTest::currentDataTag();
        for (const auto profile : {protocol::Dialect::Ut2004, protocol::Dialect::Udk}) {
            const bool swims = name == "Submarine";
            Spawned robot(name.toStdString(), profile, swims ? lake() : flatWorld(), swims ? 31.0 : 0.6);
            QCOMPARE(robot.simulation->robots().size(), std::size_t(1));
            const QString log = logOf(*robot.simulation);
            QCOMPARE(log.contains("it has the body of a " + body), name.compare(body, Qt::CaseInsensitive) != 0);
            QVERIFY(robot.answer("GETCONF {Type Robot}", "CONF").contains("{Name " + body + "}"));
            QVERIFY(robot.answer("GETGEO {Type Robot}", "GEO").contains("{Dimensions "));
            steps(*robot.simulation, 10);
            QVERIFY(robot.talker.hearLast<protocol::RobotState>().has_value());
        }
    }

    void anUnknownClassIsRefusedSoThatAPersonSeesIt() {
        Spawned robot("Nao");
        QVERIFY(robot.simulation->robots().empty());
        const QString log = logOf(*robot.simulation);
        QVERIFY2(log.contains("unknown robot class 'USARBot.Nao'; known here are") && log.contains("Talon"),
                 qPrintable(log));
        const auto answer = robot.talker.hearLast<protocol::Response>();
        QVERIFY(answer.has_value());
        QCOMPARE(QString::fromStdString(answer->type), QString("Init"));
        QCOMPARE(QString::fromStdString(answer->name), QString("USARBot.Nao"));
        QVERIFY(!answer->ok);
        Spawned udk("Nao", protocol::Dialect::Udk);
        QVERIFY(udk.talker.hearText().empty()); // UDK has no RES.
        QVERIFY(logOf(*udk.simulation).contains("unknown robot class"));
    }

    void whatRollsDrivesStraightAndTurns_data() {
        QTest::addColumn<double>("radius_m");
        QTest::addColumn<double>("spin_rad_s");
        QTest::newRow("P3AT") << 0.098 << 1.25;
        QTest::newRow("StereoP2AT") << 0.13 << 3.0;
        QTest::newRow("ATRVJr") << 0.18 << 3.0;
        QTest::newRow("Talon") << 0.10 << 4.0;
        QTest::newRow("Kenaf") << 0.07 << 4.0;
        QTest::newRow("TeleMax") << 0.10 << 4.0;
    }
    void whatRollsDrivesStraightAndTurns() {
        QFETCH(const double, radius_m);
        QFETCH(const double, spin_rad_s);
        Spawned robot(QTest::currentDataTag());
        steps(*robot.simulation, 10);
        const std::string spin = std::to_string(spin_rad_s);
        const Vec3 start_m = robot.truth().base_in_map.position_m;
        robot.talker.say("DRIVE {Left " + spin + "} {Right " + spin + "}");
        steps(*robot.simulation, 25);
        const Vec3 way_m = robot.truth().base_in_map.position_m - start_m;
        const double ideal_m = 5.0 * radius_m * spin_rad_s;
        qInfo("%.3f m of %.3f m, %.3f m aside", way_m.x(), ideal_m, way_m.y());
        QVERIFY(std::abs(way_m.x() / ideal_m - 1.0) < 0.1 && std::abs(way_m.y()) < 0.05);
        robot.talker.say("DRIVE {Left " + spin + "} {Right -" + spin + "}");
        steps(*robot.simulation, 5);
        const double yaw_rad = robot.truth().base_in_map.yaw_rad;
        qInfo("turned by %.2f rad in 1 s", yaw_rad);
        QVERIFY(yaw_rad < -0.1); // The left side goes forward: it turns right.
    }

    void anOmniRobotGoesSideways() {
        Spawned robot("OmniP2AT");
        steps(*robot.simulation, 5);
        std::string line = "DRIVE";
        for (int wheel = 0; wheel < 4; ++wheel)
            line += " {WheelNumber " + std::to_string(wheel) + "} {WheelSpeed 0} {WheelSteer 1.5708}";
        robot.talker.say(line);
        steps(*robot.simulation, 10);
        line = "DRIVE";
        for (int wheel = 0; wheel < 4; ++wheel)
            line += " {WheelNumber " + std::to_string(wheel) + "} {WheelSpeed 3}";
        const Vec3 start_m = robot.truth().base_in_map.position_m;
        robot.talker.say(line);
        steps(*robot.simulation, 20);
        const Vec3 way_m = robot.truth().base_in_map.position_m - start_m;
        QVERIFY2(std::abs(way_m.y() + 4.0 * 3.0 * 0.13) < 0.2 && std::abs(way_m.x()) < 0.1,
                 qPrintable(QString("%1 %2").arg(way_m.x()).arg(way_m.y()))); // to the right
        const auto state = robot.talker.hearLast<protocol::RobotState>();
        QVERIFY(std::abs(*state->front_steer_rad + 1.5708) < 0.05 && std::abs(*state->rear_steer_rad + 1.5708) < 0.05);
    }

    void aStereoRobotHasTwoCamerasOnOneMount() {
        Spawned robot("StereoP2AT");
        steps(*robot.simulation, 3);
        const QString cameras = robot.answer("GETCONF {Type Camera}", "CONF");
        QVERIFY2(cameras.contains("{Name CameraLeft}") && cameras.contains("{Name CameraRight}"), qPrintable(cameras));
        const QString places = robot.answer("GETGEO {Type Camera}", "GEO");
        QVERIFY2(places.contains("CameraLeft Location 0.0300,-0.0600,0.0000") &&
                     places.contains("CameraRight Location 0.0300,0.0600,0.0000"),
                 qPrintable(places));
    }

    /// The captured answers of UDK's own P3AT, as far as they are the vehicle's.
    void aP3atAnswersAsUdkDid() {
        Spawned robot("P3AT", protocol::Dialect::Udk);
        steps(*robot.simulation, 20);
        QCOMPARE(robot.answer("GETGEO {Type Robot}", "GEO"),
                 QString("GEO {Type GroundVehicle} {Name P3AT} {Dimensions 0.2480,0.3600,0.0000} {COG "
                         "0.0000,0.0000,0.0000} {WheelRadius 0.0980} {WheelSeparation 0.3600} {WheelBase 0.2480}"));
        QVERIFY(robot.answer("GETCONF {Type Robot}", "CONF")
                    .startsWith("CONF {Name P3AT} {Type GroundVehicle} {SteeringType SkidSteered} {Mass 11.9000} "
                                "{MaxSpeed 1.2999}"));
        QVERIFY(robot.answer("GETGEO {Type RangeScanner}", "GEO")
                    .startsWith("GEO {Type RangeScanner} {Name lms200} {Location 0.21,-0.00,-0.20}"));
        for (const char* const type : {"InsTest", "TachTest", "GndTruth", "Odometer"}) {
            robot.talker.hearText();
            steps(*robot.simulation, 5);
            bool heard = false;
            for (const std::string& line : robot.talker.hearText())
                heard = heard || line.find(std::string("{Name ") + type + "}") != std::string::npos;
            QVERIFY2(heard, type);
        }
    }
};

USAR_TEST(tst_ClassNames)

} // namespace tst_class_names

#include "tst_class_names.moc"
