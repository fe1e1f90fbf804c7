// Claims about a flight, judged while it goes on.
#include <QTest>

#include "core/mission/claims/claim_watch.h"
#include "tests/doubles/plan_trace.h"
#include "tests/suite/suite.h"

namespace tst_claim_watch {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr Seconds spawned_at{2.0};

/// A robot that appeared at a height of 10 m, watched from then on.
struct Flight {
    explicit Flight(std::vector<Claim> claims, CountContacts contacts = {})
        : watch(std::move(claims), std::move(contacts)) {
        pose(0.0, 0.0);
    }

    /// `above_m`: above the place where it appeared, by INS.
    void pose(double since_s, double above_m) { ins(since_s, 10.0 + above_m); }
    void ins(double since_s, double z_m) {
        protocol::InsReading reading;
        reading.base_in_map.position_m.z() = z_m;
        take(since_s, reading);
    }
    void truth(double since_s, double z_m) {
        protocol::GroundTruthReading reading;
        reading.base_in_map.position_m.z() = z_m;
        take(since_s, reading);
    }
    void take(double since_s, const protocol::InfoMessage& message) {
        watch.take(protocol::InfoLine{{++line}, "SEN", message, {}}, spawned_at, spawned_at + Seconds{since_s});
    }
    void state(double since_s, const std::string& words) {
        agent::BehaviorStatus status;
        status.state = words;
        watch.take(agent::Published(status));
        pose(since_s, 3.0);
    }

    ClaimWatch watch;
    std::uint64_t line = 0;
};

Claim within(ClaimKind kind, double from_s, double to_s, double height_m = 0.0, const std::string& name = {}) {
    return {kind, Seconds{from_s}, Seconds{to_s}, height_m, name};
}

} // namespace

class tst_ClaimWatch : public QObject {
    Q_OBJECT
private slots:
    void altitudesMustLast_data() {
        QTest::addColumn<bool>("above");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("holds");
        QTest::newRow("higher than claimed") << true << 2.5 << true;
        QTest::newRow("once too low") << true << 2.95 << false;
        QTest::newRow("lower than claimed") << false << 4.1 << true;
        QTest::newRow("once too high") << false << 3.9 << false;
    }

    void altitudesMustLast() {
        QFETCH(bool, above);
        QFETCH(double, height_m);
        QFETCH(bool, holds);
        Flight flight({within(above ? ClaimKind::AltitudeAbove : ClaimKind::AltitudeBelow, 5.0, 8.0, height_m)});
        flight.pose(4.9, above ? 0.0 : 9.0); // Before its time nothing is claimed,
        for (const auto& [since_s, above_m] : {std::pair(5.0, 3.0), {6.0, 4.0}, {7.0, 2.9}})
            flight.pose(since_s, above_m);
        QCOMPARE(flight.watch.decided(), !holds);
        flight.pose(8.1, above ? 0.0 : 9.0); // and neither after it.
        QVERIFY(flight.watch.decided());
        QCOMPARE(flight.watch.allHold(), holds);
        QCOMPARE(flight.watch.verdicts().front().why.empty(), holds);
    }

    void theTruthIsBelievedMoreThanIns() {
        Flight flight({within(ClaimKind::AltitudeAbove, 5.0, 8.0, 2.0)});
        flight.truth(0.2, 40.0); // It has another datum.
        flight.truth(6.0, 43.0);
        flight.ins(6.2, 10.0);
        flight.truth(8.2, 43.0);
        QVERIFY2(flight.watch.allHold(), flight.watch.sentence().c_str());
    }

    void contactsAreCountedBetweenItsTimesOnly_data() {
        QTest::addColumn<double>("contact_s");
        QTest::addColumn<bool>("holds");
        QTest::newRow("before") << 4.0 << true;
        QTest::newRow("within") << 6.0 << false;
        QTest::newRow("after") << 9.0 << true;
    }

    void contactsAreCountedBetweenItsTimesOnly() {
        QFETCH(double, contact_s);
        QFETCH(bool, holds);
        double now_s = 0.0;
        Flight flight({within(ClaimKind::NoContact, 5.0, 8.0)}, [&] { return 3 + int(now_s >= contact_s); });
        for (; now_s < 10.0; now_s += 0.2)
            flight.pose(now_s, 3.0);
        QVERIFY(flight.watch.decided());
        QCOMPARE(flight.watch.allHold(), holds);
    }

    void withoutASimulatorContactsCannotBeClaimed() {
        Flight flight({within(ClaimKind::NoContact, 0.0, 1.0)});
        flight.pose(2.0, 3.0);
        QVERIFY(flight.watch.decided() && !flight.watch.allHold());
        QVERIFY2(flight.watch.sentence().find("embedded simulator") != std::string::npos,
                 flight.watch.sentence().c_str());
    }

    void aStateMustBeThereOnce() {
        Flight flight({within(ClaimKind::State, 5.0, 8.0, 0.0, "Lane 2")});
        flight.pose(4.0, 3.0);
        flight.state(4.5, "scanning lane 2 of 9");
        flight.state(6.0, "scanning lane 1 of 9");
        QVERIFY(!flight.watch.decided());
        flight.state(7.0, "scanning lane 2 of 9");
        QVERIFY(flight.watch.decided() && flight.watch.allHold());
        Flight other({within(ClaimKind::State, 5.0, 8.0, 0.0, "Lane 2")});
        other.state(9.0, "landing");
        QVERIFY(other.watch.decided() && !other.watch.allHold());
    }

    void elementsOfAPlan_data() {
        QTest::addColumn<QString>("element");
        QTest::addColumn<double>("from_s");
        QTest::addColumn<bool>("runs");
        QTest::addColumn<bool>("rests");
        // The drive danger runs in the first three of twenty cycles, that is, until 0.6 s on the clock of the protocol.
        QTest::newRow("a drive while it runs") << "danger" << 0.0 << true << false;
        QTest::newRow("a drive when it is over") << "danger" << 1.0 << false << true;
        QTest::newRow("an act") << "go" << 1.0 << true << false;
        QTest::newRow("what no plan has") << "dance" << 0.0 << false << false;
    }

    void elementsOfAPlan() {
        QFETCH(QString, element);
        QFETCH(double, from_s);
        QFETCH(bool, runs);
        QFETCH(bool, rests);
        for (const auto& [kind, holds] : {std::pair(ClaimKind::ElementRuns, runs), {ClaimKind::ElementRests, rests}}) {
            ClaimWatch watch({within(kind, from_s, from_s + 1.0, 0.0, element.toStdString())});
            const auto hear = [&](double now_s) {
                watch.take(protocol::InfoLine{{1}, "SEN", protocol::InsReading{}, {}}, Seconds{0.01}, Seconds{now_s});
            };
            hear(0.1);
            const std::string plan = "((DC rover (drives ((danger (trigger ((near))) back)) ((way go)))))";
            for (const std::string& piece : test::piecesOf(plan, 20, 3))
                watch.take(agent::Published(agent::PlanTrace{piece}));
            hear(from_s + 9.0);
            QVERIFY(watch.decided());
            QCOMPARE(watch.allHold(), holds);
        }
    }

    void aFlightThatEndsTooSoonBreaksTheClaim() {
        Flight flight({within(ClaimKind::AltitudeBelow, 5.0, 8.0, 100.0)});
        flight.pose(6.0, 3.0);
        QVERIFY(!flight.watch.decided());
        flight.watch.end();
        QVERIFY(flight.watch.decided() && !flight.watch.allHold());
        QVERIFY2(flight.watch.sentence().find("6.0 s") != std::string::npos, flight.watch.sentence().c_str());
    }

    void oneBrokenClaimDecides() {
        Flight flight(
            {within(ClaimKind::AltitudeAbove, 1.0, 100.0, 1.0), within(ClaimKind::AltitudeBelow, 1.0, 9.0, 2.0)});
        flight.pose(2.0, 3.0);
        QVERIFY(flight.watch.decided() && !flight.watch.allHold());
        QVERIFY2(flight.watch.sentence().find("altitude below") != std::string::npos, flight.watch.sentence().c_str());
    }

    void withoutClaimsNothingIsDecided() {
        Flight flight({});
        flight.pose(2.0, 3.0);
        QVERIFY(!flight.watch.decided() && flight.watch.empty());
    }
};

USAR_TEST(tst_ClaimWatch)

} // namespace tst_claim_watch

#include "tst_claim_watch.moc"
