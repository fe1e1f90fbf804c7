#include <QObject>
#include <QString>
#include <QTest>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_simulation_answers {

using namespace usar;
using namespace usar::sim;

namespace {

using Lines = std::vector<std::string>;

/// A robot that has landed, and its client.
struct Landed {
    std::unique_ptr<Simulation> simulation = simulationOf(flatWorld());
    Talker talker{*simulation};

    Landed() {
        talker.say("INIT {ClassName USARBot.AirRobot} {Name R1} {Location 1,2,-0.3}");
        steps(*simulation, 30);
        talker.hearText();
    }

    /// The lines of one tick that are neither SEN nor STA.
    Lines answers() {
        simulation->step();
        Lines lines = talker.hearText();
        std::erase_if(lines,
                      [](const std::string& line) { return line.starts_with("SEN") || line.starts_with("STA"); });
        return lines;
    }
};

} // namespace

class tst_SimulationAnswers : public QObject {
    Q_OBJECT

private slots:
    void answersInUt2004sWords_data() {
        QTest::addColumn<QString>("question");
        QTest::addColumn<QString>("answer");
        QTest::newRow("robot's geometry")
            << "GETGEO {Type Robot}"
            << "GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 0.9990,0.9990,0.2400} "
               "{COG 0.0000,0.0000,0.0000}";
        QTest::newRow("robot's configuration")
            << "GETCONF {Type Robot}"
            << "CONF {Type AerialVehicle} {Name AirRobot} {SteeringType RotaryWing} {Mass 1.0000} {MaxLateralVelocity "
               "2.0000} {MaxLinearVelocity 2.0000} {MaxAltitudeVelocity 2.0000} {MaxRotationalVelocity 1.7450}";
        QTest::newRow("scanner's mount") << "GETGEO {Type RangeScanner}"
                                         << "GEO {Type RangeScanner} {Name Scanner1 Location 0.0000,0.0000,0.1000 "
                                            "Orientation 0.0000,-1.5707,0.0000 Mount HARD}";
        QTest::newRow("scanner's configuration")
            << "GETCONF {Type RangeScanner} {Name Scanner1}"
            << "CONF {Type RangeScanner} {Name Scanner1} {MaxRange 20.0000} {MinRange 0.1000} {Resolution 0.0174} {Fov "
               "3.1415} {Paning True} {Tilting False}";
        QTest::newRow("one sonar, any case") << "GETCONF {Type sonar} {Name r4}"
                                             << "CONF {Type Sonar} {Name R4} {MaxRange 5.0000} {MinRange 0.1000} "
                                                "{BeamAngle 0.2617}";
        QTest::newRow("left sonar's mount") << "GETGEO {Type Sonar} {Name L4}"
                                            << "GEO {Type Sonar} {Name L4 Location 0.1545,-0.4755,0.0000 Orientation "
                                               "0.0000,0.0000,-1.2566 Mount HARD}";
        QTest::newRow("INS") << "GETCONF {Type INS}"
                             << "CONF {Type INS} {Name INS} {ScanInterval 0.2000}";
        QTest::newRow("ground truth") << "GETGEO {Type GroundTruth}"
                                      << "GEO {Type GroundTruth} {Name GroundTruth Location 0.0000,0.0000,0.0000 "
                                         "Orientation 0.0000,0.0000,0.0000 Mount HARD}";
        QTest::newRow("no such type: bare head") << "GETGEO {Type Encoder}"
                                                 << "GEO {Type Encoder}";
        QTest::newRow("no such name: bare head") << "GETCONF {Type Sonar} {Name F1}"
                                                 << "CONF {Type Sonar} {Name F1}";
    }
    void answersInUt2004sWords() {
        QFETCH(QString, question);
        QFETCH(QString, answer);
        Landed landed;
        landed.talker.say(question.toStdString());
        Lines lines = landed.answers();
        QCOMPARE(lines.size(), 1u);
        // Unreal prints negative zeros too; they mean the same.
        QCOMPARE(QString::fromStdString(lines.front()).replace("-0.0000", "0.0000"), answer);
    }

    void onlyTheNewestOfEachKindIsAnswered() {
        Landed landed;
        landed.talker.say("GETGEO {Type Robot}");
        landed.talker.say("GETGEO {Type INS}");
        landed.talker.say("GETCONF {Type Sonar}");
        landed.talker.say("GETCONF {Type INS}");
        const Lines lines = landed.answers();
        QCOMPARE(lines.size(), 2u);
        QVERIFY(lines[0].starts_with("GEO {Type INS}"));
        QVERIFY(lines[1].starts_with("CONF {Type INS}"));
        QCOMPARE(landed.answers(), Lines{});
    }

    void namesAllSonarsFromLeftToRight() {
        Landed landed;
        landed.talker.say("GETGEO {Type Sonar}");
        landed.simulation->step();
        const auto geometry = landed.talker.hearLast<protocol::GeometryInfo>();
        QVERIFY(geometry);
        Lines names;
        for (const protocol::MountedItem& item : geometry->items)
            names.push_back(item.name);
        QCOMPARE(names, (Lines{"L4", "L3", "L2", "L1", "M0", "R1", "R2", "R3", "R4"}));
        QVERIFY(std::abs(degrees(geometry->items.front().item_in_mount.yaw_rad) - 72.0) < 0.01);
        QVERIFY(std::abs(degrees(geometry->items.back().item_in_mount.yaw_rad) + 72.0) < 0.01);
    }

    void insIsResetOnTheGround() {
        Landed landed;
        landed.talker.say("SET {Type INS} {Name INS} {Opcode POSE} {Params 5,6,-7,0,0,0.5}");
        landed.simulation->step();
        bool answered = false;
        Pose estimate;
        for (const protocol::InfoLine& line : landed.talker.hear()) {
            if (const auto* const response = std::get_if<protocol::Response>(&line.message)) {
                answered = true;
                QVERIFY(response->ok);
                QCOMPARE(response->type, std::string("INS"));
                QCOMPARE(response->name, std::string("INS"));
            }
            if (const auto* const ins = std::get_if<protocol::InsReading>(&line.message))
                estimate = ins->base_in_map;
        }
        QVERIFY(answered);
        QVERIFY((estimate.position_m - Vec3(5.0, -6.0, 7.0)).norm() < 0.01);
        QVERIFY(std::abs(estimate.yaw_rad + 0.5) < 0.01);
    }

    void setFailsWhereItCannotBeDone_data() {
        QTest::addColumn<QString>("set");
        QTest::addColumn<bool>("in_flight");
        QTest::newRow("in flight") << "SET {Type INS} {Name INS} {Opcode POSE} {Params 5,6,-7,0,0,0}" << true;
        QTest::newRow("another name") << "SET {Type INS} {Name INS2} {Opcode POSE} {Params 5,6,-7,0,0,0}" << false;
        QTest::newRow("five numbers") << "SET {Type INS} {Name INS} {Opcode POSE} {Params 5,6,-7,0,0}" << false;
        QTest::newRow("a sensor it has not got") << "SET {Type Encoder} {Name E} {Opcode RESET}" << false;
        QTest::newRow("a camera it has not got") << "SET {Type Camera} {Name C} {Opcode Zoom} {Params 0.5}" << false;
        QTest::newRow("a hand it has not got") << "SET {Type Gripper} {Opcode CLOSE}" << false;
    }
    void setFailsWhereItCannotBeDone() {
        QFETCH(QString, set);
        QFETCH(bool, in_flight);
        Landed landed;
        if (in_flight) {
            landed.talker.say("DRIVE {AltitudeVelocity 1}");
            for (int i = 0; i < 15; ++i)
                landed.simulation->step();
            landed.talker.hearText();
        }
        landed.talker.say(set.toStdString());
        landed.simulation->step();
        const auto response = landed.talker.hearLast<protocol::Response>();
        QVERIFY(response);
        QVERIFY(!response->ok);
    }

    void jointsAreSetInSilence() {
        Landed landed;
        landed.talker.say("SET {Type Joint} {Name J} {Opcode Angle} {Params 1}");
        QCOMPARE(landed.answers(), Lines{});
    }

    void insStaysWithinMillimetresOfAHoverAndDriftsInFlight() {
        Landed landed;
        landed.talker.say("DRIVE {AltitudeVelocity 1}");
        for (int i = 0; i < 25; ++i)
            landed.simulation->step();
        landed.talker.say("DRIVE {AltitudeVelocity 0} {LinearVelocity 1}");
        for (int i = 0; i < 100; ++i)
            landed.simulation->step();
        const auto ins = landed.talker.hearLast<protocol::InsReading>();
        const Pose truth = landed.simulation->robots().front().base_in_map;
        const double error_m = (ins->base_in_map.position_m - truth.position_m).norm();
        QVERIFY2(error_m > 0.005 && error_m < 1.0, qPrintable(QString::number(error_m)));
    }
};

USAR_TEST(tst_SimulationAnswers)

} // namespace tst_simulation_answers

#include "tst_simulation_answers.moc"
