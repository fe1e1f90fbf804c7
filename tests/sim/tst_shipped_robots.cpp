#include <QObject>
#include <QString>
#include <QStringList>
#include <QTest>

#include "tests/doubles/shipped_robots.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_shipped_robots {

using namespace usar;
using namespace usar::sim;

namespace {

/// A robot of a class in its world, and its client.
struct Spawned {
    std::unique_ptr<Simulation> simulation;
    Talker talker;

    Spawned(const std::string& class_name, World world, double z_m, SimulationOptions options = {})
        : simulation(simulationOf(std::move(world), options))
        , talker(*simulation) {
        talker.hearText();
        talker.say("INIT {ClassName USARBot." + class_name + "} {Name R1} {Location 0,0," + std::to_string(-z_m) + "}");
    }

    void steps(int count) {
        for (int i = 0; i < count; ++i)
            simulation->step();
    }
    RobotTruth truth() const { return simulation->robots().at(0); }
    std::string answer(const std::string& question, const std::string& word) {
        talker.hearText();
        talker.say(question);
        simulation->step();
        for (const std::string& line : talker.hearText())
            if (line.starts_with(word))
                return line;
        return {};
    }
};

} // namespace

/// Every robot that ships, spoken to over the protocol.
class tst_ShippedRobots : public QObject {
    Q_OBJECT

private slots:
    void everyRobotSpeaksAndOurReaderUnderstandsIt_data() {
        QTest::addColumn<QString>("kinds");
        QTest::newRow("AirRobot") << "SEN Sonar,SEN RangeScanner,SEN INS,SEN GroundTruth,STA";
        QTest::newRow("P2DX")
            << "SEN Sonar,SEN RangeScanner,SEN INS,SEN Odometry,SEN Encoder,SEN VictSensor,SEN GroundTruth,SEN GPS,"
               "MISSTA,STA";
        QTest::newRow("P2AT")
            << "SEN Sonar,SEN RangeScanner,SEN INS,SEN Odometry,SEN Encoder,SEN VictSensor,SEN GroundTruth,SEN GPS,"
               "MISSTA,STA";
        QTest::newRow("Sedan") << "SEN RangeScanner,SEN INS,SEN GroundTruth,SEN GPS,SEN Tachometer,STA";
        QTest::newRow("Submarine") << "SEN Range,SEN GroundTruth,MISSTA,STA";
        QTest::newRow("ERS") << "SEN INS,SEN Touch,SEN GroundTruth,SEN Helper,STA";
    }
    void everyRobotSpeaksAndOurReaderUnderstandsIt() {
        QFETCH(QString, kinds);
        const std::string name = QTest::currentDataTag();
        Spawned robot(name, name == "Submarine" ? lake() : flatWorld(), name == "Submarine" ? 31.0 : 0.5);
        robot.steps(20);
        robot.talker.hearText();
        robot.steps(1);
        QCOMPARE(robot.simulation->robots().size(), std::size_t(1));
        const std::vector<std::string> lines = robot.talker.hearText();
        QStringList heard;
        protocol::Reader reader;
        for (const std::string& line : lines) {
            heard << QString::fromStdString(kindOf(line));
            const protocol::InfoLine& read = reader.read(line);
            QVERIFY2(read.diagnostics.empty(), line.c_str());
            QVERIFY2(!std::holds_alternative<protocol::GenericMessage>(read.message), line.c_str());
        }
        QCOMPARE(heard.join(','), kinds);
        const RobotTruth truth = robot.truth();
        QVERIFY2(truth.base_in_map.position_m.allFinite() && truth.velocity_in_map_m_s.norm() < 0.5,
                 qPrintable(QString::number(truth.velocity_in_map_m_s.norm())));
    }

    void answersAsUt2004DidOfAP2dx_data() {
        QTest::addColumn<QString>("question");
        QTest::addColumn<QString>("answer");
        QTest::newRow("its configuration") << "GETCONF {Type Robot}"
                                           << "CONF {Type GroundVehicle} {Name P2DX} {SteeringType SkidSteered} {Mass ";
        QTest::newRow("its geometry") << "GETGEO {Type Robot}"
                                      << "GEO {Type GroundVehicle} {Name P2DX} {Dimensions 0.4400,0.3800,0.2200} {COG "
                                         "0.0000,0.0000,0.0000} {WheelRadius 0.0970} {WheelSeparation 0.3370} "
                                         "{WheelBase 0.0000}";
        QTest::newRow("its left-most sonar") << "GETGEO {Type Sonar} {Name F1}"
                                             << "GEO {Type Sonar} {Name F1 Location 0.1150,-0.1300,-0.0500 Orientation "
                                                "0.0000,0.0000,-1.5707 Mount HARD}";
        QTest::newRow("an encoder") << "GETCONF {Type Encoder} {Name ECLeft}"
                                    << "CONF {Type Encoder} {Name ECLeft} {Resolution 0.0174}";
        QTest::newRow("its camera mount") << "GETCONF {Type MisPkg} {Name CameraPanTilt}"
                                          << "CONF {Type MisPkg} {Name CameraPanTilt} {Link 1} {JointType Revolute} "
                                             "{MaxSpeed 1.0000} {MaxTorque 20.0000} {MinRange -3.1415} {MaxRange "
                                             "3.1415} {Link 2} {JointType Revolute}";
        QTest::newRow("its camera mount's places")
            << "GETGEO {Type MisPkg}"
            << "GEO {Type MisPkg} {Name CameraPanTilt} {Link 1} {ParentLink -1} {Location 0.1200,0.0000,-0.1400} "
               "{Orientation 0.0000,0.0000,0.0000} {Link 2} {ParentLink 1} {Location 0.0000,0.0000,-0.0400}";
        QTest::newRow("a zoom") << "SET {Type Camera} {Name Camera} {Opcode Zoom} {Params 0.8}"
                                << "RES {Time ";
    }
    void answersAsUt2004DidOfAP2dx() {
        QFETCH(QString, question);
        QFETCH(QString, answer);
        Spawned robot("P2DX", flatWorld(), 0.2);
        robot.steps(5);
        const std::string word = answer.section(' ', 0, 0).toStdString();
        const QString said = QString::fromStdString(robot.answer(question.toStdString(), word));
        QVERIFY2(said.startsWith(answer), qPrintable(said));
    }

    void noSonarHearsTheFloorOfAHall_data() {
        QTest::addColumn<int>("sonars");
        QTest::newRow("P2DX") << 8;
        QTest::newRow("P2AT") << 8;
    }
    void noSonarHearsTheFloorOfAHall() {
        QFETCH(const int, sonars);
        Spawned robot(QTest::currentDataTag(), flatWorld(), 0.35);
        robot.steps(20);
        robot.talker.hearText();
        robot.steps(1);
        protocol::Reader reader;
        int heard = 0;
        for (const std::string& line : robot.talker.hearText())
            if (const auto* all = std::get_if<protocol::SonarReadings>(&reader.read(line).message))
                for (const auto& one : all->ranges) {
                    QVERIFY2(one.range_m == 5.0, line.c_str());
                    ++heard;
                }
        QCOMPARE(heard, sonars);
    }

    void anEncoderIsResetAndOdometryToo() {
        Spawned robot("P2DX", flatWorld(), 0.2);
        robot.steps(5);
        robot.talker.say("DRIVE {Left 5} {Right 5}");
        robot.steps(10);
        robot.talker.say("DRIVE {Left 0} {Right 0}");
        robot.steps(10);
        const auto encoders = robot.talker.hearLast<protocol::EncoderReadings>();
        QVERIFY(encoders && encoders->encoders.at(0).ticks < -200); // 10 rad and more, counted down
        QVERIFY(robot.answer("SET {Type Encoder} {Opcode RESET}", "RES").ends_with("{Status OK}"));
        QVERIFY(robot.answer("SET {Type Odometry} {Name Odometry} {Opcode RESET}", "RES").ends_with("{Status OK}"));
        robot.talker.hearText();
        robot.steps(1);
        const std::vector<protocol::InfoLine> lines = robot.talker.hear();
        for (const protocol::InfoLine& line : lines) {
            if (const auto* const reading = std::get_if<protocol::EncoderReadings>(&line.message))
                QVERIFY(std::abs(reading->encoders.at(0).ticks) <= 1);
            if (const auto* const odometry = std::get_if<protocol::OdometryReading>(&line.message))
                QVERIFY(odometry->base_in_start && odometry->base_in_start->position_m.norm() < 0.01);
        }
    }

    void theCameraMountTurnsToTheLeftForANegativePan() {
        Spawned robot("P2DX", flatWorld(), 0.2);
        robot.steps(5);
        robot.talker.say("MISPKG {Name CameraPanTilt} {Link 1} {Value -1.0} {Link 2} {Value 0.5}");
        robot.steps(20);
        const auto package = robot.talker.hearLast<protocol::PackageState>();
        QVERIFY(package);
        QVERIFY(std::abs(package->links.at(0).value + 1.0) < 0.02);
        QVERIFY(std::abs(package->links.at(1).value - 0.5) < 0.02);
        QCOMPARE(package->links.at(0).torque_n_m, -20.0);
    }

    void theSubmarineFallsInHangsStillAndDives() {
        Spawned robot("Submarine", lake(), 31.0);
        robot.steps(200); // 40 s
        const double afloat_m = robot.truth().base_in_map.position_m.z();
        QVERIFY2(afloat_m > 20.0 && afloat_m < 29.9, qPrintable(QString::number(afloat_m)));
        const Vec3 drift_m_s = robot.truth().velocity_in_map_m_s;
        QVERIFY2(std::abs(drift_m_s.z()) < 0.05 && drift_m_s.norm() < 0.3,
                 qPrintable(QString::number(drift_m_s.norm())));
        const Pose lies = robot.truth().base_in_map;
        QVERIFY2(std::abs(lies.roll_rad) < 0.1 && std::abs(lies.pitch_rad) < 0.2,
                 qPrintable(QString("%1 %2").arg(lies.roll_rad).arg(lies.pitch_rad)));
        robot.talker.say("DRIVE {Propeller 160} {SternPlane -0.2}");
        robot.steps(100);
        QVERIFY(robot.truth().base_in_map.position_m.z() < afloat_m - 2.0);
        const auto state = robot.talker.hearLast<protocol::RobotState>();
        QCOMPARE(state->kind, protocol::VehicleKind::Nautic);
        QCOMPARE(state->joints.at(0), (protocol::JointAngle{"SternPlaneAngle", -0.2}));
    }

    /// sqrt(thrust / drag), reached within what the run-up leaves.
    void theSubmarineReachesItsTerminalSpeed() {
        Spawned robot("Submarine", lake(), 25.0);
        robot.talker.say("DRIVE {Propeller 160}");
        robot.steps(300);
        const double speed_m_s = robot.truth().velocity_in_map_m_s.norm();
        QVERIFY2(std::abs(speed_m_s - std::sqrt(10.0 / 3.9)) < 0.05, qPrintable(QString::number(speed_m_s)));
    }

    void theSubmarineTurnsRightForAPositiveRudder() {
        Spawned robot("Submarine", lake(), 25.0);
        robot.talker.say("DRIVE {Propeller 100} {Rudder 0.2}");
        robot.steps(50);
        QVERIFY(robot.truth().base_in_map.yaw_rad < -0.2);
    }

    void waterEndsTheBatteryOfWhatDoesNotSwim_data() {
        QTest::addColumn<double>("z_m");
        QTest::newRow("P2DX") << 0.2;
        QTest::newRow("AirRobot") << 29.0;
    }
    void waterEndsTheBatteryOfWhatDoesNotSwim() {
        QFETCH(double, z_m);
        Spawned robot(QTest::currentDataTag(), lake(), z_m);
        robot.steps(3);
        const auto state = robot.talker.hearLast<protocol::RobotState>();
        QCOMPARE(state->battery_left, Seconds{0.0});
    }

    void lightsAreSwitched() {
        Spawned robot("P2DX", flatWorld(), 0.2);
        robot.steps(2);
        robot.talker.say("DRIVE {Light true}");
        robot.steps(1);
        QCOMPARE(robot.talker.hearLast<protocol::RobotState>()->light_on, true);
    }

    void aRobotOnItsBackIsFlipped() {
        Spawned robot("P2DX", flatWorld(), 0.2);
        robot.steps(5);
        robot.talker.say("DRIVE {Flip true}");
        robot.steps(10);
        QVERIFY(std::abs(robot.truth().base_in_map.roll_rad) < 0.1);
    }
};

USAR_TEST(tst_ShippedRobots)

} // namespace tst_shipped_robots

#include "tst_shipped_robots.moc"
