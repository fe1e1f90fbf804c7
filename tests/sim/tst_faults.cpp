// Faults on request: as text, and what each does to a run.
#include <QObject>
#include <QString>
#include <QTest>

#include <cmath>

#include "core/sim/faults/fault.h"
#include "core/sim/faults/fault_schedule.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_faults {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr const char* init_air_robot = "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-3}";

std::vector<Fault> faultsOf(std::initializer_list<const char*> texts) {
    std::vector<Fault> faults;
    for (const char* text : texts)
        faults.push_back(readFault(text).value());
    return faults;
}

std::unique_ptr<Simulation> faultySimulation(std::initializer_list<const char*> texts, bool noise = false,
                                             World world = flatWorld()) {
    SimulationOptions options;
    options.noise = noise;
    options.faults = faultsOf(texts);
    return simulationOf(std::move(world), options);
}

bool logHas(Simulation& simulation, const std::string& words) {
    for (const std::string& sentence : simulation.takeLog())
        if (sentence.find(words) != std::string::npos)
            return true;
    return false;
}

} // namespace

class tst_Faults : public QObject {
    Q_OBJECT
private slots:
    void textRoundTrip_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("bias") << "sensor_bias robot=R1 sensor=INS x=0.5 yaw_deg=-3 from=60 for=30";
        QTest::newRow("dropout") << "sensor_dropout sensor=Sonar share=0.25";
        QTest::newRow("freeze") << "sensor_freeze robot=R2 sensor=F1 from=12.5";
        QTest::newRow("delay") << "link_delay by=0.4";
        QTest::newRow("loss") << "link_loss robot=R1 share=0.0005 for=10";
        QTest::newRow("cut") << "link_cut from=100";
        QTest::newRow("half open") << "link_half_open robot=R1 from=20 for=5";
        QTest::newRow("battery") << "battery robot=R1 left=60";
        QTest::newRow("rotor") << "rotor rotor=3 thrust=0.5";
        QTest::newRow("wind") << "wind speed=5 toward_deg=90 gust=1.5";
        QTest::newRow("vanish") << "vanish robot=R1 after=4";
    }
    void textRoundTrip() {
        QFETCH(const QString, text);
        const auto fault = readFault(text.toStdString());
        QVERIFY2(fault, fault ? "" : fault.error().text().c_str());
        QCOMPARE(QString::fromStdString(write(*fault)), text);
    }

    void refusesAndNamesTheMend_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("nothing") << ""
                                 << "unknown kind";
        QTest::newRow("misspelt kind") << "sensor_bais by=1"
                                       << "Did you mean 'sensor_bias'";
        QTest::newRow("misspelt key") << "wind sped=3"
                                      << "Did you mean 'speed'";
        QTest::newRow("no value") << "wind speed"
                                  << "Write it as speed=VALUE";
        QTest::newRow("no number") << "wind speed=fast"
                                   << "Give a number from 0 to 60";
        QTest::newRow("out of range") << "link_loss share=2"
                                      << "from 0 to 1";
        QTest::newRow("not a number") << "link_delay by=nan"
                                      << "is not a valid by";
        QTest::newRow("half a rotor") << "rotor rotor=1.5"
                                      << "Give a whole number from 1 to 4";
        QTest::newRow("a sensor where there is none") << "battery sensor=INS"
                                                      << "unknown word 'sensor'";
        QTest::newRow("a bias of nothing") << "sensor_bias sensor=INS x=0"
                                           << "changes nothing";
        QTest::newRow("the wind of one robot") << "wind robot=R1"
                                               << "unknown word 'robot'";
    }
    void refusesAndNamesTheMend() {
        QFETCH(const QString, text);
        QFETCH(const QString, words);
        const auto fault = readFault(text.toStdString());
        QVERIFY(!fault);
        QVERIFY2(QString::fromStdString(fault.error().text()).contains(words), fault.error().text().c_str());
    }

    void aBiasShiftsAPoseForItsTime() {
        const auto simulation =
            faultySimulation({"sensor_bias robot=r1 sensor=ins x=0.5 y=-1 yaw_deg=10 from=2 for=2"});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        const auto offset = [&](int ticks) {
            talker.hear();
            steps(*simulation, ticks);
            Pose ins;
            Pose truth;
            for (const protocol::InfoLine& line : talker.hear()) {
                if (const auto* reading = std::get_if<protocol::InsReading>(&line.message))
                    ins = reading->base_in_map;
                if (const auto* reading = std::get_if<protocol::GroundTruthReading>(&line.message))
                    truth = reading->base_in_map;
            }
            return std::pair(Vec3(ins.position_m - truth.position_m), normalizedAngle(ins.yaw_rad - truth.yaw_rad));
        };
        QVERIFY(offset(9).first.norm() < 0.05); // a hovering robot's INS without noise
        const auto [shift_m, turn_rad] = offset(5);
        QVERIFY((shift_m - Vec3(0.5, -1.0, 0.0)).norm() < 0.05);
        QVERIFY(std::abs(turn_rad - radians(10.0)) < 0.02);
        QVERIFY(offset(15).first.norm() < 0.05);
    }

    void aBiasShiftsOneSonarAmongOthers() {
        const auto simulation = faultySimulation({"sensor_bias sensor=F2 by=-1.25"});
        const auto healthy = faultySimulation({});
        Talker faulty(*simulation);
        Talker fine(*healthy);
        std::vector<protocol::SonarReadings> lines;
        for (Talker* talker : {&faulty, &fine})
            talker->say(init_air_robot);
        steps(*simulation, 5);
        steps(*healthy, 5);
        const auto odd = faulty.hearLast<protocol::SonarReadings>();
        const auto even = fine.hearLast<protocol::SonarReadings>();
        QVERIFY(odd && even);
        QCOMPARE(odd->ranges.size(), even->ranges.size()); // one line still
        for (std::size_t i = 0; i < odd->ranges.size(); ++i) {
            const double shift_m = odd->ranges[i].name == "F2" ? -1.25 : 0.0;
            QVERIFY(std::abs(odd->ranges[i].range_m - even->ranges[i].range_m - shift_m) < 1e-3);
        }
    }

    void aFrozenSensorRepeatsItself() {
        const auto simulation = faultySimulation({"sensor_freeze sensor=GroundTruth from=1 for=2"}, true);
        Talker talker(*simulation);
        talker.say(init_air_robot);
        talker.say("DRIVE {AltitudeVelocity 0} {LinearVelocity 1} {LateralVelocity 0} {RotationalVelocity 0}");
        steps(*simulation, 7);
        const auto first = talker.hearLast<protocol::GroundTruthReading>();
        steps(*simulation, 5);
        const auto again = talker.hearLast<protocol::GroundTruthReading>();
        steps(*simulation, 8);
        const auto later = talker.hearLast<protocol::GroundTruthReading>();
        QVERIFY(first && again && later);
        QCOMPARE(again->base_in_map, first->base_in_map);
        QVERIFY(*again->time > *first->time); // it is the values that stand still
        QVERIFY((later->base_in_map.position_m - first->base_in_map.position_m).norm() > 0.5);
    }

    void readingsDropOutInTheirShare() {
        const auto simulation = faultySimulation({"sensor_dropout sensor=INS share=0.3"});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        int readings = 0;
        constexpr int ticks = 1000;
        for (int i = 0; i < ticks / 100; ++i) {
            steps(*simulation, 100);
            for (const protocol::InfoLine& line : talker.hear())
                readings += std::holds_alternative<protocol::InsReading>(line.message) ? 1 : 0;
        }
        const double sigma = std::sqrt(ticks * 0.3 * 0.7);
        QVERIFY(std::abs(readings - 0.7 * ticks) < 4.0 * sigma);
    }

    void aDropOutLeavesTheOthersNoiseAsItWas() {
        const auto heard = [](std::initializer_list<const char*> texts) {
            const auto simulation = faultySimulation(texts, true);
            Talker talker(*simulation);
            talker.say(init_air_robot);
            steps(*simulation, 50);
            std::vector<std::string> lines = talker.hearText();
            std::erase_if(lines, [](const std::string& line) { return kindOf(line) == "SEN INS"; });
            return lines;
        };
        QVERIFY(heard({"sensor_dropout sensor=INS"}) == heard({}));
    }

    void delayedLinesComeLaterAndInOrder() {
        const auto simulation = faultySimulation({"link_delay by=1 from=2 for=4"});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        double newest_s = 0.0;
        for (int tick = 1; tick <= 60; ++tick) {
            simulation->step();
            for (const protocol::InfoLine& line : talker.hear())
                if (const auto* state = std::get_if<protocol::RobotState>(&line.message)) {
                    QVERIFY(state->time->count() > newest_s);
                    newest_s = state->time->count();
                }
            const double late_s = simulation->now().count() - newest_s;
            const bool delayed = simulation->now().count() > 3.5 && simulation->now().count() < 6.1;
            if (delayed || simulation->now().count() < 2.1)
                QVERIFY2(std::abs(late_s - (delayed ? 1.0 : 0.0)) < 0.01, qPrintable(QString::number(late_s)));
        }
        QCOMPARE(newest_s, simulation->now().count()); // and none is missing at the end
    }

    void aDelayedLockstepRunStaysInStep() {
        const auto simulation = faultySimulation({"link_delay by=0.6 from=2 for=10"});
        Talker talker(*simulation);
        talker.say("LOCKSTEP {On true}");
        talker.say(init_air_robot);
        int heard = 0;
        for (int tick = 0; tick < 100; ++tick) {
            QVERIFY2(simulation->readyToStep(), qPrintable(QString("stuck at tick %1").arg(tick)));
            simulation->step();
            for (const protocol::InfoLine& line : talker.hear())
                if (std::holds_alternative<protocol::RobotState>(line.message)) {
                    ++heard;
                    QVERIFY(!simulation->readyToStep()); // nothing happens before each heard tick is answered
                    talker.say("DRIVE {LinearVelocity 1}");
                    talker.say("STEP");
                }
        }
        QCOMPARE(heard, 100);
    }

    void lostBytesCostDiagnosticsOnly() {
        const auto simulation = faultySimulation({"link_loss share=0.01"});
        Talker talker(*simulation);
        talker.say("LOCKSTEP {On true}");
        talker.say(init_air_robot);
        int states = 0;
        std::size_t complaints = 0;
        for (int tick = 0; tick < 200 && simulation->readyToStep(); ++tick) {
            talker.say("DRIVE {LinearVelocity 1} {AltitudeVelocity 0}");
            simulation->step();
            for (const protocol::InfoLine& line : talker.hear()) {
                complaints += line.diagnostics.size();
                states += std::holds_alternative<protocol::RobotState>(line.message) ? 1 : 0;
            }
            talker.say("STEP");
        }
        QCOMPARE(states, 200);
        QVERIFY(complaints > 20);
    }

    void aCutIsToldToWhoeverServes() {
        const auto simulation = faultySimulation({"link_cut robot=R1 from=1"});
        Talker talker(*simulation);
        Talker other(*simulation);
        talker.say(init_air_robot);
        other.say("INIT {ClassName USARBot.P2DX} {Name R2} {Location 4,0,-0.2}");
        steps(*simulation, 4);
        QVERIFY(simulation->takeCut().empty());
        steps(*simulation, 3);
        QCOMPARE(simulation->takeCut(), std::vector<ClientId>{talker.id()});
        steps(*simulation, 3);
        QVERIFY(simulation->takeCut().empty()); // once
        QCOMPARE(simulation->faults().front().phase, FaultPhase::Over);
    }

    void aHalfOpenConnectionIsSilentAndThenTellsAll() {
        const auto simulation = faultySimulation({"link_half_open from=2 for=3"});
        Talker talker(*simulation);
        talker.say("LOCKSTEP {On true}");
        talker.say(init_air_robot);
        int silent = 0;
        int heard = 0;
        for (int tick = 0; tick < 50; ++tick) {
            QVERIFY(simulation->readyToStep()); // the world does not wait for the lost
            simulation->step();
            int now = 0;
            for (const protocol::InfoLine& line : talker.hear())
                now += std::holds_alternative<protocol::RobotState>(line.message) ? 1 : 0;
            silent += now == 0 ? 1 : 0;
            heard += now;
            for (int i = 0; i < now; ++i)
                talker.say("STEP");
        }
        QCOMPARE(silent, 15);
        QCOMPARE(heard, 50);
    }

    void timeWaitsForAClientThatIsSilencedForGood_data() {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<int>("ticks"); // made after the fault has begun
        QTest::newRow("for good") << "link_half_open from=2" << 150;
        QTest::newRow("until its end") << "link_half_open from=2 for=50" << 300;
    }
    void timeWaitsForAClientThatIsSilencedForGood() {
        QFETCH(QString, fault);
        QFETCH(int, ticks);
        const std::string text = fault.toStdString();
        const auto simulation = faultySimulation({text.c_str()});
        Talker talker(*simulation);
        talker.say("LOCKSTEP {On true}");
        talker.say(init_air_robot);
        int made = 0, silent = 0;
        for (; made < 310 && simulation->readyToStep(); ++made) {
            simulation->step();
            int now = 0;
            for (const protocol::InfoLine& line : talker.hear())
                now += std::holds_alternative<protocol::RobotState>(line.message) ? 1 : 0;
            silent += now == 0 ? 1 : 0;
            for (int i = 0; i < now; ++i)
                talker.say("STEP");
        }
        const bool for_good = !fault.contains("for=");
        QVERIFY2(std::abs(made - (for_good ? 10 + ticks : 310)) <= 2, qPrintable(QString::number(made)));
        QCOMPARE(simulation->takeSilenced(), for_good ? std::vector<std::string>{"R1"} : std::vector<std::string>{});
        QVERIFY(simulation->takeSilenced().empty()); // once
        QCOMPARE(simulation->readyToStep(), !for_good);
        simulation->endFault(simulation->faults().front().id);
        QVERIFY(simulation->readyToStep());
    }

    void anEmptyBatteryEndsTheFlight() {
        const auto simulation = faultySimulation({"battery robot=R1 left=3 from=2"});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        steps(*simulation, 15);
        QCOMPARE(talker.hearLast<protocol::RobotState>()->battery_left, Seconds{2.0});
        QVERIFY(simulation->robots().front().base_in_map.position_m.z() > 2.5);
        steps(*simulation, 25);
        QCOMPARE(talker.hearLast<protocol::RobotState>()->battery_left, Seconds{0.0});
        QVERIFY(simulation->robots().front().base_in_map.position_m.z() < 1.0);
    }

    void thePowerOfARobotCountsFromTheLastLackOfIt_data() {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<double>("powered_for_s"); // at 6 s; the robot came at 0 s
        QTest::newRow("none that takes power") << "wind speed=1" << 6.0;
        QTest::newRow("an empty battery") << "battery left=1 from=2" << 0.0;
        QTest::newRow("a weak rotor") << "rotor rotor=1 thrust=0.95 from=2" << 0.0;
        QTest::newRow("a rotor that recovers") << "rotor rotor=1 thrust=0.95 from=2 for=2" << 2.0;
    }

    void thePowerOfARobotCountsFromTheLastLackOfIt() {
        QFETCH(QString, fault);
        QFETCH(double, powered_for_s);
        const std::string text = fault.toStdString();
        const auto simulation = faultySimulation({text.c_str()});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        steps(*simulation, 30);
        const double found_s = simulation->robots().front().powered_for.count();
        QVERIFY2(std::abs(found_s - powered_for_s) < 0.25, qPrintable(QString::number(found_s)));
    }

    void aDeadRotorTurnsTheRobotOver() {
        const auto simulation = faultySimulation({"rotor rotor=2 from=2"});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        steps(*simulation, 9);
        QVERIFY(std::abs(simulation->robots().front().base_in_map.roll_rad) < 0.05);
        steps(*simulation, 20);
        QVERIFY(simulation->robots().front().broken);
    }

    void windCarriesWhatFlies() {
        const auto way = [](std::initializer_list<const char*> texts) {
            const auto simulation = faultySimulation(texts);
            Talker talker(*simulation);
            talker.say(init_air_robot);
            steps(*simulation, 100);
            return Vec3(simulation->robots().front().base_in_map.position_m - Vec3(0.0, 0.0, 3.0));
        };
        QVERIFY(way({}).norm() < 0.1);
        // 7.57 m/s at 10 m are 6 m/s at 3 m: a drag of 7.2 N. Leaning by 25 degrees, the most it may, holds 4.6 N.
        const Vec3 blown_m = way({"wind speed=7.57 toward_deg=90"});
        QVERIFY(blown_m.y() > 5.0);
        QVERIFY(std::abs(blown_m.x()) < 0.2 * blown_m.y());
        const Vec3 held_m = way({"wind speed=2 toward_deg=180"}); // a breeze that it can stand
        QVERIFY(held_m.x() < -0.01 && held_m.x() > -3.0);
    }

    void windCountsFromWhatIsBelow() {
        World bridge = flatWorld();
        bridge.boxes = {{Pose{.position_m = {0.0, 0.0, 3.5}}, {30.0, 30.0, 1.0}}};
        const auto driftOf_m = [](World world, double z_m) {
            const auto simulation = faultySimulation({"wind speed=4"}, false, std::move(world));
            Talker talker(*simulation);
            talker.say("INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0," + std::to_string(-z_m) + "}");
            steps(*simulation, 25);
            return simulation->robots().front().base_in_map.position_m.x();
        };
        const double low_m = driftOf_m(flatWorld(), 1.5);
        QVERIFY2(low_m > 0.1, qPrintable(QString::number(low_m)));
        for (const double same_m : {driftOf_m(bridge, 5.5), driftOf_m(bridge, 1.5), driftOf_m(lake(), 31.5)})
            QVERIFY(std::abs(same_m - low_m) < 0.01);
        QVERIFY(driftOf_m(flatWorld(), 5.5) > 1.2 * low_m);
    }

    // The wind of 10 m height once blew at the ground, too, and threw robots over there.
    void aRobotOnItsLegsStandsInTheWind() {
        const auto simulation = faultySimulation({"wind speed=5"});
        Talker talker(*simulation);
        talker.say("INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-0.23}");
        steps(*simulation, 15);
        const Vec3 stood_m = simulation->robots().front().base_in_map.position_m;
        steps(*simulation, 100);
        QVERIFY(!simulation->robots().front().broken);
        QVERIFY((simulation->robots().front().base_in_map.position_m - stood_m).norm() < 0.02);
    }

    // It once stood asleep while its drag added up, and left at once with the speed of the wind.
    void aRobotThatStoodInTheWindRisesFromItsPlace() {
        const auto simulation = faultySimulation({"wind speed=6"});
        Talker talker(*simulation);
        talker.say("INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-0.3}");
        const auto place_m = [&] { return simulation->robots().front().base_in_map.position_m; };
        steps(*simulation, 25); // It lands by itself.
        const Vec3 landed_m = place_m();
        steps(*simulation, 35);
        const Vec3 stood_m = place_m();
        QVERIFY2((stood_m - landed_m).norm() < 0.02, qPrintable(QString::number((stood_m - landed_m).norm())));
        talker.say("DRIVE {AltitudeVelocity 0.5} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}");
        steps(*simulation, 15);
        const RobotTruth robot = simulation->robots().front();
        QVERIFY(!robot.broken);
        QVERIFY(robot.base_in_map.position_m.z() > 0.5);
        const double drifted_m = (robot.base_in_map.position_m - stood_m).head<2>().norm();
        QVERIFY2(drifted_m < 1.5, qPrintable(QString::number(drifted_m)));
    }

    void gustsHaveTheirStatistics() {
        Wind wind({Vec3(4.0, 0.0, 0.0), 1.5}, seeded(1, 2));
        constexpr int count = 200'000;
        const Seconds dt{1.0};
        Vec3 sum = Vec3::Zero();
        Vec3 squares = Vec3::Zero();
        double products = 0.0;
        double last = 0.0;
        for (int i = 0; i < count; ++i) {
            const Vec3 gust_m_s = wind.step(dt) - Vec3(4.0, 0.0, 0.0);
            sum += gust_m_s;
            squares += gust_m_s.cwiseAbs2();
            products += last * gust_m_s.x();
            last = gust_m_s.x();
        }
        QVERIFY((sum / count).norm() < 0.1);
        const Vec3 sigma_m_s = (squares / count).cwiseSqrt();
        QVERIFY((sigma_m_s - Vec3(1.5, 1.5, 0.75)).cwiseAbs().maxCoeff() < 0.05);
        // Correlation over a second is exp(-V dt / L): 4 m/s over 68 m.
        QVERIFY(std::abs(products / count / (1.5 * 1.5) - std::exp(-4.0 / 68.0)) < 0.05);
    }

    void aVanishedRobotLeavesItsConnection() {
        const auto simulation = faultySimulation({"vanish robot=R1 after=1"});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        steps(*simulation, 5);
        QVERIFY(talker.hearLast<protocol::RobotState>());
        steps(*simulation, 5);
        QVERIFY(logHas(*simulation, "'R1' has vanished"));
        QCOMPARE(simulation->takeVanished(), std::vector<std::string>{"R1"});
        QVERIFY(simulation->takeVanished().empty());
        talker.hear();
        steps(*simulation, 5);
        QVERIFY(talker.hear().empty());
        QVERIFY(simulation->robots().empty());
        QVERIFY(simulation->lastGone() && simulation->lastGone()->name == "R1");
        QCOMPARE(simulation->clientCount(), std::size_t(1));
    }

    void whatARobotHasNotIsSaid() {
        const auto simulation = faultySimulation({"rotor robot=R1", "sensor_freeze robot=R1 sensor=Radar"});
        Talker talker(*simulation);
        talker.say(init_p2dx);
        steps(*simulation, 2);
        const std::vector<std::string> log = simulation->takeLog();
        const auto has = [&](const char* words) {
            return std::ranges::any_of(log, [&](const auto& one) { return one.find(words) != std::string::npos; });
        };
        QVERIFY(has("'rotor robot=R1' does nothing to 'R1', which has no rotors"));
        QVERIFY(has("which has no such sensor"));
    }

    void sameFaultsSameBytes() {
        const auto heard = [] {
            const auto simulation =
                faultySimulation({"wind speed=3 gust=1", "sensor_dropout share=0.2", "link_loss"}, true);
            return heardBy(*simulation, init_air_robot, 200);
        };
        const std::string first = heard();
        QVERIFY(first.size() > 50'000);
        QVERIFY(first == heard());
    }

    void aFaultCanBeAddedAndEndedMeanwhile() {
        const auto simulation = faultySimulation({});
        Talker talker(*simulation);
        talker.say(init_air_robot);
        steps(*simulation, 5);
        const int id = simulation->addFault(readFault("sensor_dropout sensor=INS").value());
        talker.hear();
        steps(*simulation, 5);
        QVERIFY(!talker.hearLast<protocol::InsReading>());
        QVERIFY(logHas(*simulation, "fault begins: sensor_dropout sensor=INS"));
        QVERIFY(simulation->endFault(id));
        steps(*simulation, 5);
        QVERIFY(talker.hearLast<protocol::InsReading>());
        QVERIFY(logHas(*simulation, "fault ends"));
        QVERIFY(!simulation->endFault(id));
        QVERIFY(!simulation->endFault(99));
    }
};

USAR_TEST(tst_Faults)

} // namespace tst_faults

#include "tst_faults.moc"
