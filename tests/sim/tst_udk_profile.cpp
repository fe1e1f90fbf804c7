#include <QObject>
#include <QRegularExpression>
#include <QString>
#include <QTest>

#include "core/protocol/dialect_detector.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_udk_profile {

using namespace usar;
using namespace usar::sim;

namespace {

/// A simulation that speaks as UDK does, and one robot in it.
struct Udk {
    std::unique_ptr<Simulation> simulation;
    Talker talker;

    explicit Udk(const std::string& class_name, double z_m = 0.3, double yaw_on_wire_rad = 0.0, int ticks = 10)
        : simulation(simulationOf(world(), options()))
        , talker(*simulation) {
        talker.say("INIT {ClassName USARBot." + class_name + "} {Name R1} {Location 0,0," + std::to_string(-z_m) +
                   "} {Rotation 0,0," + std::to_string(yaw_on_wire_rad) + "}");
        steps(ticks);
    }
    static World world() {
        World world = flatWorld();
        world.start_poses.push_back({"Start", {.position_m = {1.5, -2.25, 0.5}, .yaw_rad = 0.5}});
        return world;
    }
    static SimulationOptions options() {
        SimulationOptions options;
        options.profile = protocol::Dialect::Udk;
        options.tick = Seconds{0.1};
        options.physics_steps_per_tick = 25;
        return options;
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i)
            simulation->step();
    }
    std::vector<std::string> linesOf(const std::string& kind, int ticks) {
        talker.hearText();
        steps(ticks);
        std::vector<std::string> lines = talker.hearText();
        std::erase_if(lines, [&](const std::string& line) { return kindOf(line) != kind; });
        return lines;
    }
    std::vector<std::string> answers(const std::string& question) {
        talker.hearText();
        talker.say(question);
        steps(1);
        std::vector<std::string> lines = talker.hearText();
        std::erase_if(lines, [](const std::string& line) {
            return line.starts_with("SEN") || line.starts_with("STA") || line.starts_with("ASTA") ||
                   line.starts_with("EFF");
        });
        return lines;
    }
};

} // namespace

/// protocol.md 7, row by row.
class tst_UdkProfile : public QObject {
    Q_OBJECT

private slots:
    void camerasAreConfiguredInDegreesAndUnasked() {
        Udk udk("P2DX");
        const std::string line = "CONF {Type Camera} {Name Camera}{TextureOffsetX 0}{TextureOffsetY 0}"
                                 "{TextureResolutionX 320}{TextureResolutionY 240}{CameraDefFov 80.0000}"
                                 "{CameraMinFov 20.0000}{CameraMaxFov 120.0000}{CameraFov 80.0000}";
        const auto unasked = udk.talker.hearText();
        QCOMPARE(std::count_if(unasked.begin(), unasked.end(),
                               [](const std::string& one) { return one.starts_with("CONF {Type Camera}"); }),
                 1);
        const auto asked = udk.answers("GETCONF {Type Camera}");
        QCOMPARE(asked.size(), 1u);
        QCOMPARE(QString::fromStdString(asked[0]), QString::fromStdString(line));
        Udk blind("AirRobot");
        for (const std::string& one : blind.talker.hearText())
            QVERIFY(!one.starts_with("CONF"));
    }

    void eachCameraHasALineAndAPlaceInTheWindow() {
        Udk udk("StereoP2AT");
        Talker second(*udk.simulation);
        second.say("INIT {ClassName P2DX} {Name R2} {Location 5,0,-0.3}");
        udk.steps(2);
        const auto camerasIn = [](const std::vector<std::string>& lines) {
            QStringList cameras;
            static const QRegularExpression shape(
                "^CONF \\{Type Camera\\} \\{Name (\\w+)\\}\\{TextureOffsetX (\\d+)\\}\\{TextureOffsetY (\\d+)\\}");
            for (const std::string& line : lines)
                if (const auto match = shape.match(QString::fromStdString(line)); match.hasMatch())
                    cameras << match.captured(1) + ' ' + match.captured(2) + ' ' + match.captured(3);
            return cameras;
        };
        QCOMPARE(camerasIn(udk.talker.hearText()), (QStringList{"CameraLeft 0 0", "CameraRight 320 0"}));
        QCOMPARE(camerasIn(second.hearText()), (QStringList{"Camera 0 240"}));
        const auto asked = udk.answers("GETCONF {Type Camera}");
        QCOMPARE(asked.size(), std::size_t(1));
        QVERIFY2(asked[0].find(" {Name CameraRight}{TextureOffsetX 320}{TextureOffsetY 0}") != std::string::npos,
                 asked[0].c_str());
    }

    void eachSensorHasALineOfItsOwn() {
        Udk udk("P2DX");
        const auto sonars = udk.linesOf("SEN Sonar", 2);
        QCOMPARE(sonars.size(), std::size_t(8));
        QVERIFY2(sonars[0].find("{Type Sonar} {Name F1} {Range ") != std::string::npos, sonars[0].c_str());
        QVERIFY(sonars[0].starts_with("SEN {Time "));
    }

    void stateComesTenTimesASecondAndTimeFirst() {
        Udk udk("P2DX");
        const auto states = udk.linesOf("STA", 10);
        QCOMPARE(states.size(), std::size_t(10));
        QVERIFY2(states[0].starts_with("STA {Time 1.1") &&
                     states[0].find("{Battery 11") < states[0].find("{Type GroundVehicle}"),
                 states[0].c_str());
        QVERIFY(states[0].find("{View") == std::string::npos);
        QVERIFY(states[0].find("{LightIntensity 100}") != std::string::npos);
    }

    void sensorsKeepTheirOwnIntervals_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("lines");
        QTest::newRow("ground truth") << "SEN GroundTruth" << 20;
        QTest::newRow("odometry") << "SEN Odometry" << 20;
        QTest::newRow("INS") << "SEN INS" << 10;
        QTest::newRow("scanner") << "SEN RangeScanner" << 10;
        QTest::newRow("GPS") << "SEN GPS" << 4;
        QTest::newRow("camera mount") << "ASTA" << 20;
    }
    void sensorsKeepTheirOwnIntervals() {
        QFETCH(QString, kind);
        QFETCH(int, lines);
        Udk udk("P2DX");
        QCOMPARE(static_cast<int>(udk.linesOf(kind.toStdString(), 20).size()), lines);
    }

    /// The first ticks of the captured P3AT, with the sonars that it did not have.
    void ticksBeginWithTheStateAndTimersRingAtTheEndOfTheirIntervals() {
        Udk udk("P3AT", 0.3, 0.0, 0);
        QStringList ticks;
        for (int i = 0; i < 5; ++i) {
            udk.steps(1);
            QStringList kinds;
            for (const std::string& kind : kindsOf(udk.talker.hearText()))
                if (kinds.isEmpty() || kinds.back() != QString::fromStdString(kind).remove("SEN "))
                    kinds << QString::fromStdString(kind).remove("SEN ");
            ticks << kinds.join(' ');
        }
        const QString all = "STA GroundTruth Odometry INS Sonar RangeScanner Tachometer Encoder";
        QCOMPARE(ticks, (QStringList{"NFO CONF STA GroundTruth Odometry", all, "STA GroundTruth Odometry", all,
                                     "STA GroundTruth Odometry"}));
    }

    void aScanIntervalIsTheOneThatIsKept_data() {
        QTest::addColumn<QString>("type");
        QTest::addColumn<QString>("interval");
        QTest::newRow("GroundTruth") << "GroundTruth"
                                     << "0.1000";
        QTest::newRow("Odometry") << "Odometry"
                                  << "0.1000";
        QTest::newRow("INS") << "INS"
                             << "0.2000";
        QTest::newRow("Tachometer") << "Tachometer"
                                    << "0.2000";
        QTest::newRow("GPS") << "GPS"
                             << "0.5000";
    }
    void aScanIntervalIsTheOneThatIsKept() {
        QFETCH(const QString, type);
        QFETCH(const QString, interval);
        Udk udk(type == "GPS" ? "P2DX" : "P3AT");
        const auto answers = udk.answers("GETCONF {Type " + type.toStdString() + "}");
        QCOMPARE(answers.size(), std::size_t(1));
        QVERIFY2(QString::fromStdString(answers[0]).contains("{ScanInterval " + interval + "}"), answers[0].c_str());
    }

    void theTachometerCountsWheelsLeftAndRight() {
        Udk udk("P3AT");
        udk.talker.say("DRIVE {Left 1} {Right -1}");
        const std::string line = udk.linesOf("SEN Tachometer", 20).back();
        static const QRegularExpression alternating("\\{Vel \\d\\.\\d+,-\\d\\.\\d+,\\d\\.\\d+,-\\d\\.\\d+\\}");
        QVERIFY2(alternating.match(QString::fromStdString(line)).hasMatch(), line.c_str());
    }

    void anAccelerometerFeelsTheMeanSinceItsLastReading() {
        SimulationOptions options = Udk::options();
        options.noise = false;
        auto robots = std::make_shared<RobotCatalog>(*doubles::shippedRobots());
        for (RobotModel& robot : *robots)
            robot.sensors.push_back({"Accel", "A", -1, {}, "HARD", {}, {}});
        options.robots = robots;
        const auto simulation = simulationOf(flatWorld(), options);
        Talker talker(*simulation);
        talker.say("INIT {ClassName P2DX} {Name R1} {Location 0,0,-10}");
        steps(*simulation, 8);
        const auto falling = talker.hearLast<protocol::AccelerationReading>();
        QVERIFY(falling);
        QVERIFY2(std::abs(falling->acceleration_m_s2.z() + 9.81) < 0.2,
                 qPrintable(QString::number(falling->acceleration_m_s2.z())));
    }

    /// As captured: mounted 0.20 above the base, and begins at INIT's height.
    void theInsBeginsAtItsMount() {
        Udk udk("P3AT", 0.3, 0.0, 0);
        const auto lines = udk.linesOf("SEN INS", 2);
        QCOMPARE(lines.size(), std::size_t(1));
        const std::string& line = lines.front();
        QVERIFY2(line.find("{Location 0.00,0.00,-0.50} {Orientation 0.00,0.00,0.00}") != std::string::npos,
                 line.c_str());
    }

    void onlyGroundVehiclesTellOfTheirLights_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<bool>("lights");
        QTest::newRow("a rover") << "P2AT" << true;
        QTest::newRow("a car") << "Sedan" << true;
        QTest::newRow("legs") << "ERS" << false;
        QTest::newRow("in the air") << "AirRobot" << false;
    }
    void onlyGroundVehiclesTellOfTheirLights() {
        QFETCH(const QString, robot);
        QFETCH(const bool, lights);
        Udk udk(robot.toStdString());
        QCOMPARE(udk.linesOf("STA", 1).at(0).find("{Light") != std::string::npos, lights);
    }

    void packagesAreActuators_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("question");
        QTest::addColumn<QRegularExpression>("answer");
        const QString at = "-?[0-9]\\.[0-9]{2}";
        const QString pose = QString("\\{Location %1,%1,%1\\} \\{Orientation %1,%1,%1\\}").arg(at);
        const QString geometry = "\\{Name %2\\} %1 \\{Mount %3\\} \\{Link 1\\} \\{Parent 0\\} %1 "
                                 "\\{Link 2\\} \\{Parent 1\\} %1";
        const auto row = [](const char* name, const char* robot, const char* question, const QString& answer) {
            QTest::newRow(name) << robot << question << QRegularExpression("^" + answer + "$");
        };
        row("places", "P2DX", "GETGEO {Type Actuator}",
            "GEO \\{Type Actuator\\} " + geometry.arg(pose, "CameraPanTilt", "P2DX"));
        row("places by the old word", "P2DX", "GETGEO {Type MisPkg} {Name CameraPanTilt}",
            "GEO \\{Type MisPkg\\} " + geometry.arg(pose, "CameraPanTilt", "P2DX"));
        row("an arm's tip", "TeleMax", "GETGEO {Type Actuator} {Name TeleMaxArm}",
            QString("GEO \\{Type Actuator\\} ") + geometry.arg(pose, "TeleMaxArm", "TeleMax") +
                QString(" \\{Link 3\\} \\{Parent 2\\} %1 \\{Tip %2,%2,%2\\}").arg(pose, at));
        row("limits", "P2DX", "GETCONF {Type Actuator}",
            "CONF \\{Type Actuator\\} \\{Name CameraPanTilt\\}( \\{Link [12]\\} \\{JointType Revolute\\} \\{MaxTorque "
            "[0-9.]+\\} \\{MinValue [-0-9.]+\\} \\{MaxValue [-0-9.]+\\}){2}");
        row("the old question, without packages", "P3AT", "GETCONF {Type MisPkg}", "CONF \\{Type MisPkg\\}");
    }
    void packagesAreActuators() {
        QFETCH(const QString, robot);
        QFETCH(const QString, question);
        QFETCH(const QRegularExpression, answer);
        Udk udk(robot.toStdString());
        const auto answers = udk.answers(question.toStdString());
        QCOMPARE(answers.size(), std::size_t(1));
        QVERIFY2(answer.match(QString::fromStdString(answers[0])).hasMatch(), answers[0].c_str());
    }

    void theCapturedVehicleAnswersWordForWord() {
        Udk udk("P3AT");
        const auto first = [&](const char* question) { return QString::fromStdString(udk.answers(question).at(0)); };
        QCOMPARE(first("GETCONF {Type Robot}").replace("{MaxTorque 60.0000}", "{MaxTorque 50000.0000}"),
                 QString("CONF {Name P3AT} {Type GroundVehicle} {SteeringType SkidSteered} {Mass 11.9000} "
                         "{MaxSpeed 1.2999} {MaxTorque 50000.0000} {MaxFrontSteer 0} {MaxRearSteer 0}"));
        QVERIFY(first("GETCONF {Type RangeScanner}").endsWith("{Panning True} {Tilting False}"));
        QCOMPARE(first("GETCONF {Type INS}"), QString("CONF {Type INS} {Name InsTest} {ScanInterval 0.2000}"));
        QCOMPARE(first("GETGEO {Type RangeScanner}").replace("-0.00", "0.00"),
                 QString("GEO {Type RangeScanner} {Name lms200} {Location 0.21,0.00,-0.20} {Orientation "
                         "0.00,0.00,0.00} {Mount P3AT}"));
        udk.linesOf("STA", 1);
        const auto encoders = udk.linesOf("SEN Encoder", 2);
        QCOMPARE(encoders.size(), std::size_t(2));
        QVERIFY(encoders[0].ends_with("{Type Encoder} {Name W1} {Tick 0}") &&
                encoders[1].ends_with("{Type Encoder} {Name W2} {Tick 0}"));
    }

    void aFlyingRobotHasNoTypeAndTheInsNoTime() {
        Udk udk("AirRobot", 5.0);
        QVERIFY(udk.linesOf("STA", 1).at(0).find("{Type") == std::string::npos);
        QVERIFY(udk.linesOf("SEN INS", 2).at(0).starts_with("SEN {Type INS}"));
    }

    void linesHaveUdksNumbers_data() {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QRegularExpression>("shape");
        const auto row = [](const char* name, const char* robot, const char* kind, const char* shape) {
            QTest::newRow(name) << robot << kind << QRegularExpression(shape);
        };
        row("a GPS tells its time", "P2DX", "SEN GPS", "^SEN \\{Time [0-9.]+\\} \\{Type GPS\\} ");
        row("ground truth turned left is negative", "P2DX", "SEN GroundTruth",
            "\\{Orientation -?0\\.0[0-9],-?0\\.0[0-9],-1\\.5[0-9]\\}");
        row("a skid robot's angles are whole", "P2DX", "STA", "\\{FrontSteer 0\\} \\{RearSteer 0\\}");
        row("a car's angles are not, in front", "Sedan", "STA", "\\{FrontSteer 0\\.[0-9]{4}\\} \\{RearSteer 0\\}");
        row("no negative zero", "P2DX", "STA", "^(?!.*-0\\.0000)");
    }
    void linesHaveUdksNumbers() {
        QFETCH(const QString, robot);
        QFETCH(const QString, kind);
        QFETCH(const QRegularExpression, shape);
        Udk udk(robot.toStdString(), 0.3, -1.5708);
        const auto lines = udk.linesOf(kind.toStdString(), 20);
        QVERIFY(!lines.empty());
        for (const std::string& line : lines)
            QVERIFY2(shape.match(QString::fromStdString(line)).hasMatch(), line.c_str());
    }

    void startPosesHaveFourDecimals() {
        Udk udk("P2DX");
        const auto answers = udk.answers("GETSTARTPOSES");
        QCOMPARE(answers.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(answers[0]),
                 QString("NFO {StartPoses 1} {Start 1.5000,2.2500,-0.5000 0.0000,0.0000,-0.5000}"));
    }

    void classesThatUdkDoesNotHaveAreNotThere_data() {
        QTest::addColumn<QString>("type");
        QTest::newRow("victims") << "VictSensor";
        QTest::newRow("tags") << "RFID";
    }
    void classesThatUdkDoesNotHaveAreNotThere() {
        QFETCH(const QString, type);
        const std::string in_braces = "{Type " + type.toStdString() + "}";
        Udk udk("P2DX");
        QVERIFY(udk.linesOf("SEN " + type.toStdString(), 20).empty());
        QVERIFY(udk.answers("GETCONF " + in_braces).empty());
        QVERIFY(udk.answers("GETGEO " + in_braces).empty());
    }

    void theScannerHasTwoDecimals() {
        Udk udk("P2DX");
        const std::string scan = udk.linesOf("SEN RangeScanner", 2).at(0);
        const std::size_t at = scan.find("{Range ") + 7;
        const std::string first = scan.substr(at, scan.find(',', at) - at);
        QCOMPARE(first.size() - first.find('.') - 1, std::size_t(2));
    }

    void answersAtOnceAndSaysNothingOfWhatIsNotThere() {
        Udk udk("P2DX");
        udk.talker.hearText();
        udk.talker.say("GETCONF {Type Robot}");
        udk.talker.say("GETCONF {Type Sonar}");
        udk.talker.say("GETGEO {Type RangeScanner}");
        const auto answers = udk.answers("GETGEO {Type Robot}");
        QCOMPARE(answers.size(), std::size_t(4));
        QVERIFY2(answers[0].starts_with("CONF {Name P2DX} {Type GroundVehicle}"), answers[0].c_str());
        QVERIFY2(answers[2].find("{Name Scanner1} {Location 0.06,") != std::string::npos, answers[2].c_str());
        QVERIFY(answers[2].ends_with("{Mount P2DX}"));
        QVERIFY(udk.answers("GETCONF {Type Unicorn}").empty());
        QVERIFY(udk.answers("SET {Type Odometry} {Name Odometry} {Opcode RESET}").empty());
    }

    void turnsByDegreesASecond() {
        Udk udk("AirRobot", 5.0);
        udk.talker.say("DRIVE {RotationalVelocity 45}");
        udk.steps(20);
        const double yaw_rad = udk.simulation->robots().at(0).base_in_map.yaw_rad;
        QVERIFY2(yaw_rad < -0.9 && yaw_rad > -1.7, qPrintable(QString::number(yaw_rad)));
    }

    void ourReaderTakesItAllAndKnowsItForUdk_data() {
        QTest::addColumn<QString>("robot");
        for (const char* name : {"AirRobot", "P2DX", "P2AT", "Sedan", "ERS"})
            QTest::newRow(name) << name;
    }
    void ourReaderTakesItAllAndKnowsItForUdk() {
        QFETCH(QString, robot);
        Udk udk(robot.toStdString());
        protocol::Reader reader;
        protocol::DialectDetector detector;
        udk.talker.hearText();
        udk.talker.say("GETCONF {Type Robot}");
        udk.talker.say("GETGEO {Type MisPkg}");
        udk.steps(20);
        for (const std::string& line : udk.talker.hearText()) {
            const protocol::InfoLine& read = reader.read(line);
            QVERIFY2(read.diagnostics.empty() && !std::holds_alternative<protocol::GenericMessage>(read.message),
                     line.c_str());
            detector.take(line);
        }
        QCOMPARE(detector.dialect(), protocol::Dialect::Udk);
    }
};

USAR_TEST(tst_UdkProfile)

} // namespace tst_udk_profile

#include "tst_udk_profile.moc"
