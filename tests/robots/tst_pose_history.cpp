#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/pose_estimate.h"
#include "tests/suite/suite.h"

namespace tst_pose_history {

using namespace usar;
using namespace usar::airrobot;

class tst_PoseHistory : public QObject {
    Q_OBJECT

    static Pose at(double x_m, double yaw_rad = 0.0) { return {Vec3(x_m, 0, 0), 0, 0, yaw_rad}; }

private slots:
    void knowsNothingAtFirst() {
        const PoseHistory history;
        QVERIFY(!history.at(Seconds(1.0)));
        QCOMPARE(history.velocity_m_s(), Vec3(Vec3::Zero()));
        QCOMPARE(history.yawRate_rad_s(), 0.0);
    }

    void placesATimeBetweenTwoPoses_data() {
        QTest::addColumn<double>("time_s");
        QTest::addColumn<double>("x_m");
        QTest::newRow("before the first") << 9.0 << 0.0;
        QTest::newRow("on the first") << 10.0 << 0.0;
        QTest::newRow("half way") << 10.1 << 0.5;
        QTest::newRow("on the last") << 10.2 << 1.0;
        QTest::newRow("after the last") << 11.0 << 1.0;
    }
    void placesATimeBetweenTwoPoses() {
        QFETCH(double, time_s);
        QFETCH(double, x_m);
        PoseHistory history;
        history.add(Seconds(10.0), at(0.0));
        history.add(Seconds(10.2), at(1.0));
        QVERIFY(std::abs(history.at(Seconds(time_s))->position_m.x() - x_m) < 1e-9);
    }

    void turnsTheShortWay() {
        PoseHistory history;
        history.add(Seconds(0.0), at(0.0, radians(170.0)));
        history.add(Seconds(1.0), at(0.0, radians(-170.0)));
        QVERIFY(std::abs(std::abs(history.at(Seconds(0.5))->yaw_rad) - pi) < 1e-9);
        QVERIFY(std::abs(history.yawRate_rad_s() - radians(20.0)) < 1e-9);
    }

    void replacesAPoseOfTheSameTime() {
        PoseHistory history;
        history.add(Seconds(1.0), at(0.0));
        history.add(Seconds(1.0), at(5.0));
        QCOMPARE(history.at(Seconds(1.0))->position_m.x(), 5.0);
        QCOMPARE(history.velocity_m_s(), Vec3(Vec3::Zero()));
    }

    void meansTheVelocityOverTheLastTicks() {
        PoseHistory history;
        for (int tick = 0; tick <= 20; ++tick)
            history.add(Seconds(0.2 * tick), at(0.3 * tick));
        QVERIFY(std::abs(history.velocity_m_s().x() - 1.5) < 1e-9);
    }

    void forgetsAfterItsSpanAndOnRequest() {
        PoseHistory history(Seconds(1.0));
        for (int tick = 0; tick <= 20; ++tick)
            history.add(Seconds(0.2 * tick), at(tick));
        QVERIFY(history.at(Seconds(0.0))->position_m.x() >= 14.0);
        history.clear();
        QVERIFY(!history.at(Seconds(4.0)));
    }
};

USAR_TEST(tst_PoseHistory)

} // namespace tst_pose_history

#include "tst_pose_history.moc"
