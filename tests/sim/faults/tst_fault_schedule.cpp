// When faults begin and end, what each number of them allows, and a connection that they degrade.
#include <cmath>
#include <limits>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/faults/fault_schedule.h"
#include "core/sim/faults/faulty_wire.h"
#include "core/sim/faults/wind_profile.h"
#include "tests/suite/suite.h"

namespace tst_fault_schedule {

using namespace usar;
using namespace usar::sim;

namespace {

Fault faultOf(const std::string& text) {
    return readFault(text).value();
}

/// The phase of each fault at these times, one letter each: to Come, Active, Over.
QString phasesOf(const std::string& text, std::initializer_list<double> times_s) {
    FaultSchedule schedule(1);
    schedule.add(faultOf(text));
    QString phases;
    for (const double time_s : times_s) {
        schedule.advance(Seconds{time_s});
        phases += QLatin1Char("CAO"[static_cast<int>(schedule.all().front().phase)]);
    }
    return phases;
}

std::string withNumber(const FaultDescription& kind, const FaultNumber& number, double value) {
    const std::string other = kind.kind == FaultKind::SensorBias && number.name != "by" ? " by=1" : "";
    return std::string(kind.word) + other + " " + std::string(number.name) + "=" + std::to_string(value);
}

FaultyWire wireWith(std::initializer_list<const char*> faults) {
    FaultyWire wire(seeded(5, 1));
    std::vector<Fault> active;
    for (const char* const text : faults)
        active.push_back(faultOf(text));
    wire.setFaults(active);
    return wire;
}

} // namespace

class tst_FaultSchedule : public QObject {
    Q_OBJECT

private slots:
    void phasesFollowTheClock_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("phases"); // at 0, 1, 2, 3 and 4 s
        QTest::newRow("from the start to the end") << "wind speed=2"
                                                   << "AAAAA";
        QTest::newRow("begins later") << "wind speed=2 from=2"
                                      << "CCAAA";
        QTest::newRow("begins between two ticks") << "wind speed=2 from=1.5"
                                                  << "CCAAA";
        QTest::newRow("ends") << "wind speed=2 for=2"
                              << "AAOOO";
        QTest::newRow("begins and ends") << "wind speed=2 from=1 for=2"
                                         << "CAAOO";
        QTest::newRow("shorter than a tick") << "wind speed=2 from=1.25 for=0.5"
                                             << "CCOOO";
        QTest::newRow("of no length") << "wind speed=2 for=0"
                                      << "OOOOO";
        QTest::newRow("beyond the run") << "wind speed=2 from=1000"
                                        << "CCCCC";
    }
    void phasesFollowTheClock() {
        QFETCH(const QString, text);
        QFETCH(const QString, phases);
        QCOMPARE(phasesOf(text.toStdString(), {0.0, 1.0, 2.0, 3.0, 4.0}), phases);
    }

    void timeThatGoesBackwardRevivesNothing() {
        QCOMPARE(phasesOf("wind from=1 for=2", {0.0, 2.0, 0.5, 3.0, 2.0, 0.0}), QString("CAAOOO"));
    }

    void endsAtTheNextTickWhenTold_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("while it is active") << "battery robot=R1";
        QTest::newRow("before it has begun") << "battery robot=R1 from=100";
        QTest::newRow("while a wind blows") << "wind speed=4 gust=1";
    }
    void endsAtTheNextTickWhenTold() {
        QFETCH(const QString, text);
        FaultSchedule schedule(1);
        const int id = schedule.add(faultOf(text.toStdString()));
        QCOMPARE(id, 1);
        schedule.advance(Seconds{0.0});
        QVERIFY(schedule.end(id));
        QVERIFY(schedule.all().front().phase != FaultPhase::Over); // not yet
        const std::vector<FaultStatus> turned = schedule.advance(Seconds{0.2});
        QCOMPARE(turned.size(), std::size_t{1});
        QCOMPARE(QString::fromStdString(sentenceOf(turned.front())), "fault ends: " + text);
        QVERIFY(!schedule.end(id)); // it is over
        QVERIFY(schedule.advance(Seconds{0.4}).empty());
        QVERIFY(schedule.activeOn("R1").empty());
        QCOMPARE(schedule.wind(Seconds{0.2}).norm(), 0.0);
    }

    void onlyKnownNumbersEnd() {
        FaultSchedule schedule(1);
        for (const int id : {-1, 0, 1, 2})
            QVERIFY(!schedule.end(id));
        QCOMPARE(schedule.add(faultOf("link_cut")), 1);
        QCOMPARE(schedule.add(faultOf("link_cut")), 2);
        for (const int id : {-1, 0, 3, std::numeric_limits<int>::max()})
            QVERIFY(!schedule.end(id));
        QVERIFY(schedule.end(2));
    }

    void concernsTheRobotThatItNames() {
        FaultSchedule schedule(1);
        for (const char* const text : {"battery robot=r1", "link_delay", "rotor robot=R2 rotor=2", "vanish from=9"})
            schedule.add(faultOf(text));
        schedule.advance(Seconds{0.0});
        const auto kindsOn = [&](const char* robot) {
            std::vector<FaultKind> kinds;
            for (const Fault& fault : schedule.activeOn(robot))
                kinds.push_back(fault.kind);
            return kinds;
        };
        using enum FaultKind;
        QVERIFY((kindsOn("R1") == std::vector{Battery, LinkDelay}));
        QVERIFY((kindsOn("R2") == std::vector{LinkDelay, Rotor}));
        QVERIFY((kindsOn("") == std::vector{LinkDelay}));
        QVERIFY((kindsOn("R11") == std::vector{LinkDelay}));
    }

    void aCutTakesEveryRobotOnceAndIsOver() {
        FaultSchedule schedule(1);
        schedule.add(faultOf("link_cut from=1"));
        schedule.add(faultOf("link_cut robot=R9 from=1"));
        schedule.advance(Seconds{0.0});
        QVERIFY(!schedule.takeCut("R1")); // not yet
        schedule.advance(Seconds{1.0});
        QVERIFY(schedule.takeCut("R1"));
        QVERIFY(schedule.takeCut("R2"));
        schedule.advance(Seconds{1.2});
        QVERIFY(!schedule.takeCut("R1"));
        QVERIFY(schedule.takeCut("R9")); // its own has not been used
    }

    void windsAddUp_data() {
        QTest::addColumn<double>("toward_deg");
        QTest::addColumn<Vec3>("expected_m_s");
        QTest::newRow("forward") << 0.0 << Vec3(5.0, 0.0, 0.0);
        QTest::newRow("across") << 90.0 << Vec3(2.0, 3.0, 0.0);
        QTest::newRow("against") << 180.0 << Vec3(-1.0, 0.0, 0.0);
        QTest::newRow("across, the other way round") << -90.0 << Vec3(2.0, -3.0, 0.0);
    }
    void windsAddUp() {
        QFETCH(const double, toward_deg);
        QFETCH(const Vec3, expected_m_s);
        FaultSchedule schedule(1);
        QCOMPARE(schedule.wind(Seconds{0.1}).norm(), 0.0);
        schedule.add(faultOf("wind speed=2"));
        schedule.add(faultOf("wind speed=3 toward_deg=" + std::to_string(toward_deg)));
        schedule.advance(Seconds{0.0});
        for (int i = 0; i < 3; ++i)
            QVERIFY((schedule.wind(Seconds{0.1}) - expected_m_s).norm() < 1e-12);
    }

    /// By hand: ln(10 / 0.03) is 5.809; 0.03 e is 0.0815 m, where the logarithm is 1.
    void windGrowsWithTheHeight_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("share");
        QTest::newRow("below the ground") << -2.0 << 0.0;
        QTest::newRow("at the roughness length") << 0.03 << 0.0;
        QTest::newRow("e times as high") << 0.08155 << 0.1721;
        QTest::newRow("a robot on its legs") << 0.23 << 0.3506;
        QTest::newRow("3 m") << 3.0 << 0.7927;
        QTest::newRow("where the AirRobot scans") << 6.0 << 0.9121;
        QTest::newRow("where it is stated") << 10.0 << 1.0;
        QTest::newRow("30 m") << 30.0 << 1.1891;
    }
    void windGrowsWithTheHeight() {
        QFETCH(const double, height_m);
        QFETCH(const double, share);
        QVERIFY2(std::abs(windShare(height_m) - share) < 1e-4, qPrintable(QString::number(windShare(height_m))));
    }

    void gustsDependOnTheSeedAndTheNumberAlone() {
        const auto gustOf = [](std::uint64_t seed, int before) {
            FaultSchedule schedule(seed);
            for (int i = 0; i < before; ++i)
                schedule.add(faultOf("link_cut from=50"));
            schedule.add(faultOf("wind speed=0 gust=2"));
            schedule.advance(Seconds{0.0});
            schedule.wind(Seconds{0.2});
            return schedule.wind(Seconds{0.2});
        };
        QVERIFY(gustOf(1, 0) == gustOf(1, 0));
        QVERIFY(gustOf(1, 0) != gustOf(2, 0));
        QVERIFY(gustOf(1, 0) != gustOf(1, 1));
    }

    void everyKindIsDescribedForForms() {
        for (const FaultDescription& kind : faultKinds()) {
            QVERIFY(&descriptionOf(kind.kind) == &kind);
            QVERIFY(!kind.word.empty() && !kind.help.empty());
            for (const FaultNumber& number : kind.numbers) {
                QVERIFY2(!number.help.empty(), std::string(number.name).c_str());
                QVERIFY(number.smallest < number.largest);
                QVERIFY(number.smallest <= number.usual && number.usual <= number.largest);
            }
        }
    }

    void everyNumberHasItsLimits() {
        for (const FaultDescription& kind : faultKinds())
            for (const FaultNumber& number : kind.numbers) {
                for (const double good : {number.smallest, number.largest}) {
                    const auto fault = readFault(withNumber(kind, number, good));
                    QVERIFY2(fault, withNumber(kind, number, good).c_str());
                    QCOMPARE(fault->number(number.name), good);
                    QCOMPARE(readFault(write(*fault))->number(number.name), good);
                }
                for (const double bad : {number.smallest - 0.01, number.largest + 0.01}) {
                    const auto fault = readFault(withNumber(kind, number, bad));
                    QVERIFY2(!fault, withNumber(kind, number, bad).c_str());
                    QVERIFY(fault.error().what.find("is not a valid " + std::string(number.name)) != std::string::npos);
                    QVERIFY(fault.error().mend.find(" number from ") != std::string::npos);
                }
            }
    }

    void delayedLinesKeepTheirOrder() {
        FaultyWire wire = wireWith({"link_delay by=1"});
        wire.push("a\r\n", Seconds{0.0}, false, true);
        wire.setFaults({});
        wire.push("b\r\n", Seconds{0.2}, false, true); // not before what is on its way
        QCOMPARE(wire.take(Seconds{0.8}).bytes, std::string());
        const FaultyWire::Arrived arrived = wire.take(Seconds{1.0});
        QCOMPARE(arrived.bytes, std::string("a\r\nb\r\n"));
        QCOMPARE(arrived.ticks, 2);
        QCOMPARE(wire.take(Seconds{9.0}).bytes, std::string());
    }

    void delaysAddUpAndTicksMayBeInexact() {
        FaultyWire wire = wireWith({"link_delay by=0.1", "link_delay by=0.2"});
        wire.push("a", Seconds{0.0}, false, false);
        QCOMPARE(wire.take(Seconds{0.2}).bytes, std::string());
        QCOMPARE(wire.take(Seconds{0.1 + 0.1 + 0.1 - 1e-9}).bytes, std::string("a"));
    }

    void aHalfOpenConnectionHoldsBothWays() {
        FaultyWire wire = wireWith({"link_half_open"});
        wire.push("a\r\n", Seconds{0.0}, false, true);
        wire.push(protocol::Command(protocol::DriveSwitches{.light_on = true}), Seconds{0.0});
        QVERIFY(wire.take(Seconds{100.0}).bytes.empty());
        QVERIFY(wire.takeCommands(Seconds{100.0}).empty());
        wire.setFaults({});
        QCOMPARE(wire.take(Seconds{100.0}).bytes, std::string("a\r\n"));
        QCOMPARE(wire.takeCommands(Seconds{100.0}).size(), std::size_t{1});
    }

    void aClockIsNeverDamaged_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("lockstep");
        QTest::addColumn<QString>("arrives");
        QTest::newRow("a tick in lockstep") << "STA {Time 1}\r\n" << true << "STA {Time 1}\r\n";
        QTest::newRow("the answer to LOCKSTEP") << "NFO {Lockstep On}\r\n" << true << "NFO {Lockstep On}\r\n";
        QTest::newRow("a sensor before a tick") << "SEN {x}\r\nSTA {y}\r\n" << true << "\r\nSTA {y}\r\n";
        QTest::newRow("a tick without lockstep") << "STA {Time 1}\r\n" << false << "";
    }
    void aClockIsNeverDamaged() {
        QFETCH(const QString, text);
        QFETCH(const bool, lockstep);
        QFETCH(const QString, arrives);
        FaultyWire wire = wireWith({"link_loss share=1"});
        wire.push(text.toStdString(), Seconds{0.0}, lockstep, true);
        QCOMPARE(QString::fromStdString(wire.take(Seconds{0.0}).bytes), arrives);
    }

    void commandsAreDamagedExceptSteps() {
        FaultyWire all = wireWith({"link_loss share=1"});
        QCOMPARE(all.garbled("DRIVE {Left 1}"), std::string());
        QCOMPARE(all.garbled("STEP"), std::string("STEP"));
        QCOMPARE(all.garbled("LOCKSTEP {On true}"), std::string("LOCKSTEP {On true}"));
        FaultyWire none = wireWith({});
        QCOMPARE(none.garbled("DRIVE {Left 1}"), std::string("DRIVE {Left 1}"));
        FaultyWire half = wireWith({"link_loss share=0.5", "link_loss share=0.5"});
        const std::size_t left = half.garbled(std::string(10000, 'x')).size();
        QVERIFY2(left > 2200 && left < 2800, qPrintable(QString::number(left))); // a quarter gets through
    }

    void buffersHaveAnEnd() {
        FaultyWire wire = wireWith({"link_half_open"});
        const std::string megabyte(std::size_t(1) << 20, 'x');
        for (int i = 0; i < 8; ++i)
            wire.push(megabyte, Seconds{0.0}, false, true);
        QVERIFY(!wire.overfull());
        wire.push("x", Seconds{0.0}, false, true);
        QVERIFY(wire.overfull());
        wire.setFaults({});
        QCOMPARE(wire.take(Seconds{0.0}).bytes.size(), (std::size_t(8) << 20) + 1);
        QVERIFY(!wire.overfull());
        for (int i = 0; i < 65536; ++i)
            wire.push(protocol::Command(protocol::DriveSwitches{}), Seconds{0.0});
        QVERIFY(!wire.overfull());
        wire.push(protocol::Command(protocol::DriveSwitches{}), Seconds{0.0});
        QVERIFY(wire.overfull());
    }
};

USAR_TEST(tst_FaultSchedule)

} // namespace tst_fault_schedule

#include "tst_fault_schedule.moc"
