#include <QTest>

#include <cmath>
#include <functional>

#include "core/mapping/level_flight.h"
#include "tests/suite/suite.h"

namespace tst_level_flight {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr double tick_s = 0.2;

/// A flight along its yaw; every function gets the time in seconds.
struct Flight {
    std::function<double(double)> speed_m_s = [](double) { return 1.0; };
    std::function<double(double)> climb_m_s = [](double) { return 0.0; };
    std::function<double(double)> turn_rad_s = [](double) { return 0.0; };
};

/// The true attitude of a robot with this speed in calm air, and one that wobbles.
Pose lean(double speed_m_s, double time_s) {
    const double wobble_rad = 0.03 * std::sin(5.0 * time_s);
    return {Vec3::Zero(), wobble_rad, speed_m_s * speed_m_s / 49.0 + wobble_rad, 0.0};
}

/// Flies for so long and calls `told` with the true pose and with the INS's, whose roll and pitch have drifted.
void fly(const Flight& flight, double duration_s, const Vec2& drift_rad_s,
         const std::function<void(Seconds, const Pose& truth, const Pose& ins)>& told) {
    Pose truth{.position_m = {0.0, 0.0, 6.0}};
    for (double time_s = tick_s; time_s < duration_s; time_s += tick_s) {
        const double speed_m_s = flight.speed_m_s(time_s);
        truth.yaw_rad += flight.turn_rad_s(time_s) * tick_s;
        truth.position_m += tick_s * Vec3(speed_m_s * std::cos(truth.yaw_rad), speed_m_s * std::sin(truth.yaw_rad),
                                          flight.climb_m_s(time_s));
        const Pose leaning = lean(speed_m_s, time_s);
        truth.roll_rad = leaning.roll_rad;
        truth.pitch_rad = leaning.pitch_rad;
        Pose ins = truth;
        ins.roll_rad += drift_rad_s.x() * time_s;
        ins.pitch_rad += drift_rad_s.y() * time_s;
        told(Seconds(time_s), truth, ins);
    }
}

} // namespace

class tst_LevelFlight : public QObject {
    Q_OBJECT
private slots:
    void takesTheDriftAway_data() {
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("roll_rad_s");
        QTest::addColumn<double>("pitch_rad_s");
        QTest::newRow("of the roll, slowly") << 0.6 << 3e-4 << 0.0;
        QTest::newRow("of the pitch, at the usual speed") << 1.0 << 0.0 << -3e-4;
        QTest::newRow("of both, fast") << 2.0 << -3e-4 << 3e-4;
        QTest::newRow("where there is none") << 2.0 << 0.0 << 0.0;
    }
    void takesTheDriftAway() {
        QFETCH(double, speed_m_s);
        QFETCH(double, roll_rad_s);
        QFETCH(double, pitch_rad_s);
        const Vec2 drift_rad_s(roll_rad_s, pitch_rad_s);
        LevelFlight level;
        level.insWasSet();
        Vec2 worst_rad = Vec2::Zero();
        fly({.speed_m_s = [&](double) { return speed_m_s; }}, 120.0, drift_rad_s,
            [&](Seconds now, const Pose& truth, const Pose& ins) {
                level.take(now, ins);
                const Pose corrected = level.corrected(ins);
                worst_rad = worst_rad.cwiseMax(
                    Vec2(corrected.roll_rad - truth.roll_rad, corrected.pitch_rad - truth.pitch_rad).cwiseAbs());
            });
        QVERIFY(level.steady() && level.calm());
        QVERIFY2(worst_rad.x() < 0.035, qPrintable(QString::number(worst_rad.x()))); // The wobble is 0.03.
        QVERIFY2(worst_rad.y() < 0.012, qPrintable(QString::number(worst_rad.y())));
    }

    void doubtsWhatItKnowsAsItRolls() {
        LevelFlight level;
        level.insWasSet();
        QVERIFY(level.doubt_rad() < 0.005);
        double now_s = 0.0;
        for (int tick = 0; tick < 100; ++tick) // It looks up ten times where it stands.
            level.take(Seconds(now_s += tick_s), {{0.0, 0.0, 6.0}, 0.24 * std::sin(0.6 * tick), 0.0, 0.0});
        const double doubt_rad = level.doubt_rad();
        QVERIFY2(doubt_rad > 0.02 && doubt_rad < 0.1, qPrintable(QString::number(doubt_rad)));
        fly({}, 20.0, Vec2::Zero(),
            [&](Seconds time, const Pose&, const Pose& ins) { level.take(time + Seconds(now_s), ins); });
        QVERIFY(level.doubt_rad() < 0.3 * doubt_rad);
    }

    void isSteadyOnlyWithoutTurnsClimbsAndAccelerations_data() {
        QTest::addColumn<double>("acceleration_m_s2");
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<double>("turn_rad_s");
        QTest::addColumn<bool>("steady");
        QTest::newRow("straight ahead") << 0.0 << 0.0 << 0.0 << true;
        QTest::newRow("with a small correction of everything") << 0.03 << 0.1 << 0.03 << true;
        QTest::newRow("speeding up") << 0.5 << 0.0 << 0.0 << false;
        QTest::newRow("braking") << -0.5 << 0.0 << 0.0 << false;
        QTest::newRow("climbing") << 0.0 << 0.8 << 0.0 << false;
        QTest::newRow("sinking") << 0.0 << -0.8 << 0.0 << false;
        QTest::newRow("turning") << 0.0 << 0.0 << 0.3 << false;
    }
    void isSteadyOnlyWithoutTurnsClimbsAndAccelerations() {
        QFETCH(double, acceleration_m_s2);
        QFETCH(double, climb_m_s);
        QFETCH(double, turn_rad_s);
        QFETCH(bool, steady);
        LevelFlight level;
        fly({[&](double time_s) { return 1.5 + acceleration_m_s2 * time_s; }, [&](double) { return climb_m_s; },
             [&](double) { return turn_rad_s; }},
            2.0, Vec2::Zero(), [&](Seconds now, const Pose&, const Pose& ins) { level.take(now, ins); });
        QCOMPARE(level.steady(), steady);
    }

    /// As in random survey 143497: it leans to turn back while its velocity has been the same for a second.
    void learnsNothingAsItGoesToAndFro() {
        LevelFlight level;
        level.insWasSet();
        Pose shown{.position_m = {0.0, 0.0, 5.0}};
        Seconds now{0.0};
        double left = 1.0;
        double worst_rad = 0.0;
        const auto fly_way = [&](int ticks) {
            left = -left;
            for (int tick = 0; tick < ticks; ++tick) {
                now += Seconds(tick_s);
                shown.position_m += tick_s * Vec3(0.1, 0.5 * left, 0.0);
                shown.roll_rad = tick == ticks - 1 ? 0.13 * left : tick == 0 ? -0.13 * left : 0.0;
                level.take(now, shown);
                worst_rad = std::max(worst_rad, level.drift_rad().norm());
            }
        };
        for (int i = 0; i < 40; ++i)
            fly_way(4); // All the while it is not steady, so that the drift is less and less known.
        for (int i = 0; i < 4; ++i)
            fly_way(6);
        QVERIFY2(worst_rad < 0.04, qPrintable(QString::number(worst_rad)));
    }

    void isNotSteadyWhereItStands() {
        LevelFlight level;
        fly({.speed_m_s = [](double) { return 0.0; }}, 5.0, Vec2::Zero(),
            [&](Seconds now, const Pose&, const Pose& ins) { level.take(now, ins); });
        QVERIFY(!level.steady());
    }

    void leavesTheAnglesAloneInWindUntilTheInsIsSet_data() {
        QTest::addColumn<double>("roll_rad");
        QTest::addColumn<int>("lanes");
        QTest::newRow("strong wind, at once") << 0.12 << 1;
        QTest::newRow("weak wind, after some turns") << 0.04 << 4;
    }
    void leavesTheAnglesAloneInWindUntilTheInsIsSet() {
        QFETCH(double, roll_rad);
        QFETCH(int, lanes);
        LevelFlight level;
        level.insWasSet();
        Pose last;
        const auto fly_for = [&](double from_s, const Vec2& lean_rad) {
            fly({}, 30.0, Vec2::Zero(), [&](Seconds now, const Pose&, const Pose& ins) {
                last = ins;
                last.roll_rad = lean_rad.x();
                last.pitch_rad = 1.0 / 49.0 + lean_rad.y();
                level.take(now + Seconds(from_s), last);
            });
        };
        for (int lane = 0; lane < lanes; ++lane) {
            fly_for(40.0 * lane, {lane % 2 == 0 ? roll_rad : -roll_rad, 0.0});
        }
        QVERIFY(!level.calm());
        QCOMPARE(level.corrected(last), last);
        level.insWasSet();
        fly_for(1000.0, Vec2::Zero());
        QVERIFY(level.calm());
    }

    void learnsAJumpOfTheDrift() {
        LevelFlight level;
        level.insWasSet();
        fly({}, 60.0, Vec2::Zero(), [&](Seconds now, const Pose&, Pose ins) {
            ins.pitch_rad += now > Seconds(20.0) ? 0.06 : 0.0;
            level.take(now, ins);
        });
        QVERIFY(level.calm());
        QVERIFY(std::abs(level.drift_rad().y() - 0.06) < 0.01);
    }

    void survivesWhatIsNoFlight_data() {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<double>("x_m");
        QTest::newRow("no number") << 0.2 << std::nan("");
        QTest::newRow("the same time again") << 0.0 << 1.0;
        QTest::newRow("time that runs backward") << -5.0 << 1.0;
    }
    void survivesWhatIsNoFlight() {
        QFETCH(double, seconds);
        QFETCH(double, x_m);
        LevelFlight level;
        level.take(Seconds(10.0), {});
        level.take(Seconds(10.0 + seconds), {.position_m = {x_m, 0.0, 0.0}, .roll_rad = 0.3});
        QVERIFY(!level.steady());
        QCOMPARE(level.drift_rad(), Vec2(Vec2::Zero()));
    }
};

USAR_TEST(tst_LevelFlight)

} // namespace tst_level_flight

#include "tst_level_flight.moc"
