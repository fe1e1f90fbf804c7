#include <cmath>

#include <QTest>

#include "core/mission/fleet/velocity_watch.h"
#include "tests/suite/suite.h"

namespace tst_velocity_watch {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr double tick_s = 0.2;

protocol::InfoLine stateAt(double time_s) {
    protocol::RobotState state;
    state.time = Seconds(time_s);
    return {{1}, {}, state, {}};
}

/// A robot that goes round a circle to the left, forward at 1 m/s, turning at 0.5 rad/s.
Pose onCircle(double time_s) {
    const double turned_rad = 0.5 * time_s;
    return {.position_m = {2.0 * std::sin(turned_rad), 2.0 - 2.0 * std::cos(turned_rad), 0.1 * time_s},
            .yaw_rad = normalizedAngle(3.0 + turned_rad)}; // over the end of the circle
}

Pose turnedBy3(const Pose& pose) {
    const double c = std::cos(3.0);
    const double s = std::sin(3.0);
    Pose turned = pose;
    turned.position_m.head<2>() =
        Vec2(c * pose.position_m.x() - s * pose.position_m.y(), s * pose.position_m.x() + c * pose.position_m.y());
    return turned;
}

template <class Reading>
SessionUpdate tickOf(int tick, const Pose& pose) {
    SessionUpdate update;
    Reading reading;
    if constexpr (std::is_same_v<Reading, protocol::OdometryReading>)
        reading.base_in_start = pose;
    else
        reading.base_in_map = pose;
    update.lines = {stateAt(tick * tick_s), {{2}, {}, reading, {}}};
    return update;
}

} // namespace

class tst_VelocityWatch : public QObject {
    Q_OBJECT
private slots:
    void itTellsTheMotionInTheRobotsFrame() {
        VelocityWatch watch;
        QVERIFY(!watch.twist());
        for (int tick = 0; tick < 10; ++tick)
            watch.take(tickOf<protocol::GroundTruthReading>(tick, turnedBy3(onCircle(tick * tick_s))));
        const auto twist = watch.twist();
        QVERIFY(twist && !twist->planar);
        QVERIFY2(std::abs(twist->velocity_m_s.x() - 1.0) < 0.02, qPrintable(QString::number(twist->velocity_m_s.x())));
        QVERIFY2(std::abs(twist->velocity_m_s.y()) < 0.02, qPrintable(QString::number(twist->velocity_m_s.y())));
        QVERIFY(std::abs(twist->velocity_m_s.z() - 0.1) < 1e-9);
        QVERIFY(std::abs(twist->yaw_rate_rad_s - 0.5) < 1e-9);
    }

    void groundTruthIsBelievedMoreThanOdometry() {
        VelocityWatch watch;
        watch.take(tickOf<protocol::OdometryReading>(0, {}));
        watch.take(tickOf<protocol::OdometryReading>(1, {.position_m = {1.0, 0.0, 0.0}}));
        QVERIFY(watch.twist() && watch.twist()->planar && watch.twist()->velocity_m_s.x() > 4.9);
        for (int tick = 2; tick < 6; ++tick) {
            watch.take(tickOf<protocol::GroundTruthReading>(tick, {}));
            watch.take(tickOf<protocol::OdometryReading>(tick, {.position_m = {double(tick), 0.0, 0.0}}));
        }
        QCOMPARE(watch.twist()->velocity_m_s.norm(), 0.0);
    }

    void aRobotThatFellSilentHasNoVelocity() {
        VelocityWatch watch;
        watch.take(tickOf<protocol::InsReading>(0, {}));
        watch.take(tickOf<protocol::InsReading>(1, {}));
        QVERIFY(watch.twist());
        SessionUpdate later;
        later.lines = {stateAt(5.0)};
        watch.take(later);
        QVERIFY(!watch.twist());
    }

    void aReplayThatIsWoundBackBeginsAnew() {
        VelocityWatch watch;
        watch.take(tickOf<protocol::InsReading>(0, {}));
        watch.take(tickOf<protocol::InsReading>(1, {}));
        SessionUpdate again;
        again.rewound = true;
        watch.take(again);
        QVERIFY(!watch.twist());
    }
};

USAR_TEST(tst_VelocityWatch)

} // namespace tst_velocity_watch

#include "tst_velocity_watch.moc"
