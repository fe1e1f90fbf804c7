#include <QObject>
#include <QTest>

#include "robots/sample/hop.h"
#include "tests/suite/suite.h"

namespace tst_hop {

using namespace usar;
using namespace usar::agent;

namespace {

ParameterSet parametersWith(const std::map<std::string, ParameterValue>& values) {
    return ParameterSet::make(sample::hopParameters(), values).value();
}

/// The sample's behavior, and what it said in its last tick.
struct Flight {
    explicit Flight(const std::map<std::string, ParameterValue>& values = {}) : hop(parametersWith(values)) {}

    void tick(const Vec3& position_m) {
        modules.take({LineNumber{++line}, "", protocol::InsReading{{}, "INS", Pose{position_m, 0.0, 0.0, 0.0}}, {}});
        tick();
    }
    void tick() {
        now_s += 0.2;
        hop.tick({Seconds(now_s), LineNumber{line}, modules}, port);
        listen();
    }
    void order(Order order) {
        hop.order(order, port);
        listen();
    }
    /// `count` ticks in one place.
    void ticks(int count, const Vec3& position_m) {
        for (int i = 0; i < count; ++i)
            tick(position_m);
    }
    bool commands(double climb_m_s, double forward_m_s) const {
        return drive == protocol::AerialDrive{climb_m_s, forward_m_s, 0.0, 0.0};
    }

    sample::Hop hop;
    modules::RobotModules modules;
    CommandPort port;
    std::uint64_t line = 0;
    double now_s = 40.0;
    std::optional<protocol::AerialDrive> drive; ///< of the last tick; nullopt if it sent none
    std::optional<BehaviorStatus> status;
    std::optional<BehaviorFinished> ending;
    std::string source;

private:
    void listen() {
        drive.reset();
        for (const CausedCommand& caused : port.takeCommands()) {
            drive = std::get<protocol::AerialDrive>(caused.command);
            source = by::toText(caused.cause.source);
        }
        for (const Published& value : port.takePublished()) {
            if (const auto* news = std::get_if<BehaviorStatus>(&value))
                status = *news;
            if (const auto* end = std::get_if<BehaviorFinished>(&value))
                ending = *end;
        }
    }
};

} // namespace

class tst_Hop : public QObject {
    Q_OBJECT

private slots:
    void climbsFliesForwardAndLands() {
        Flight flight;
        flight.tick({2, 3, 10});
        QVERIFY(flight.commands(0.5, 0.0));
        QCOMPARE(flight.status->state, std::string("climbing"));
        QCOMPARE(flight.source, std::string("climbing"));
        flight.tick({2, 3, 12.9});
        QVERIFY(flight.commands(0.5, 0.0));
        flight.tick({2, 3, 13});
        QVERIFY(flight.commands(0.0, 1.0));
        QCOMPARE(flight.status->state, std::string("flying forward"));
        flight.tick({6.9, 3, 13});
        QVERIFY(flight.commands(0.0, 1.0));
        flight.tick({7, 3, 13});
        QVERIFY(flight.commands(-0.4, 0.0));
        QCOMPARE(flight.status->state, std::string("landing"));
        QVERIFY(!flight.ending);
    }

    void hasLandedWhenItHasNotSunkForASecond() {
        Flight flight;
        flight.tick({0, 0, 0});
        flight.order(Order::LandNow);
        for (int i = 0; i < 20; ++i) {
            flight.tick({0, 0, -0.1 * i});
            QVERIFY(flight.commands(-0.4, 0.0));
        }
        int still = 0;
        while (!flight.ending && ++still < 20)
            flight.tick({0, 0, -1.9});
        QVERIFY(still >= 5 && still <= 6); // A second in ticks of 0.2 s
        QVERIFY(flight.ending->success);
        QVERIFY(flight.commands(0.0, 0.0));
        QCOMPARE(flight.status->state, std::string("on the ground"));
        QCOMPARE(*flight.status->progress_pct, 100.0);
        flight.status.reset();
        flight.tick({0, 0, 0});
        QVERIFY(!flight.drive && !flight.status); // It is over
    }

    void saysNothingWithoutItsIns() {
        Flight flight;
        for (int i = 0; i < 10; ++i)
            flight.tick();
        QVERIFY(!flight.drive && !flight.status);
        flight.tick({0, 0, 0});
        QCOMPARE(flight.status->elapsed, Seconds(0.0)); // Its time begins with the first reading
    }

    void standsWhilePausedAndGoesOnWhereItWas() {
        Flight flight;
        flight.tick({0, 0, 0});
        flight.tick({0, 0, 3});
        flight.order(Order::Pause);
        QVERIFY(flight.commands(0.0, 0.0)); // At once, not with the next tick
        flight.ticks(50, {9, 0, 3});        // The wind blows it past its goal
        QVERIFY(flight.commands(0.0, 0.0));
        QVERIFY(flight.status->paused);
        QCOMPARE(flight.source, std::string("paused"));
        flight.order(Order::Resume);
        flight.tick({4, 0, 3});
        QVERIFY(flight.commands(0.0, 1.0));
        QVERIFY(!flight.status->paused);
    }

    void landsFromEveryState_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("paused");
        QTest::newRow("climbing") << 1.0 << false;
        QTest::newRow("flying") << 3.0 << false;
        QTest::newRow("paused") << 3.0 << true;
    }
    void landsFromEveryState() {
        QFETCH(double, height_m);
        QFETCH(bool, paused);
        Flight flight;
        flight.tick({0, 0, 0});
        flight.tick({0, 0, height_m});
        if (paused)
            flight.order(Order::Pause);
        flight.order(Order::LandNow);
        flight.tick({0, 0, height_m});
        QVERIFY(flight.commands(-0.4, 0.0)); // The order ends the pause
    }

    void obeysItsParametersAlsoOnTheWay() {
        Flight flight({{"height_m", 6.0}, {"distance_m", 20.0}});
        flight.tick({0, 0, 0});
        flight.tick({0, 0, 5.9});
        QVERIFY(flight.commands(0.5, 0.0));
        flight.hop.setParameters(parametersWith({{"height_m", 5.0}, {"distance_m", 20.0}}));
        flight.tick({0, 0, 5.9});
        QVERIFY(flight.commands(0.0, 1.0));
    }

    void tellsItsProgressByTheWayFlown_data() {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("flown_m");
        QTest::addColumn<double>("progress_pct");
        QTest::newRow("at the start") << 10.0 << 0.0 << 0.0;
        QTest::newRow("half way") << 10.0 << 5.0 << 49.5;
        QTest::newRow("too far") << 10.0 << 30.0 << 99.0; // It has not landed
        QTest::newRow("straight up and down") << 0.0 << 2.0 << 0.0;
    }
    void tellsItsProgressByTheWayFlown() {
        QFETCH(double, distance_m);
        QFETCH(double, flown_m);
        QFETCH(double, progress_pct);
        Flight flight({{"distance_m", distance_m}});
        flight.tick({0, 0, 0});
        flight.tick({0, flown_m, 3});
        QVERIFY(std::abs(*flight.status->progress_pct - progress_pct) < 1e-9);
        QCOMPARE(flight.status->distance_flown_m, flown_m);
    }
};

USAR_TEST(tst_Hop)

} // namespace tst_hop

#include "tst_hop.moc"
