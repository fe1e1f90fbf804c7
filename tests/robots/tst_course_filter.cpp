#include <QObject>
#include <QTest>

#include "core/base/random.h"
#include "robots/airrobot/flight/pose_estimate.h"
#include "tests/suite/suite.h"

namespace tst_course_filter {

using namespace usar;
using namespace usar::airrobot;

class tst_CourseFilter : public QObject {
    Q_OBJECT

    /// A robot that does what it is told; its INS is off by `error_rad`.
    struct Flight {
        CourseFilter filter;
        Random random{5};
        double true_yaw_rad = 0.0;
        double error_rad = 0.0;
        double noise = 0.0;
        Vec2 at_m = Vec2::Zero();
        double tick_s = 0.2;
        Seconds now{50.0};

        void tick(const Vec2& commanded_m_s, bool moves = true) {
            const Vec2 step_m = Eigen::Rotation2Dd(true_yaw_rad) * commanded_m_s * (moves ? tick_s : 0.0);
            now += Seconds(tick_s);
            at_m += step_m + step_m.norm() * noise * Vec2(gaussian(random, 1.0), gaussian(random, 1.0));
            filter.update(now, {Vec3(at_m.x(), at_m.y(), 6.0), 0, 0, normalizedAngle(true_yaw_rad + error_rad)},
                          commanded_m_s);
        }
        /// The way in which the real error comes about.
        void turn(double angle_rad) {
            for (int i = 0; i < 20; ++i) {
                true_yaw_rad += angle_rad / 20.0;
                error_rad += angle_rad / 20.0 * 0.05 * gaussian(random, 1.0);
                tick({0, 0});
            }
        }
        double remaining_rad() const { return normalizedAngle(error_rad + filter.correction_rad()); }
    };

private slots:
    void isSureOfTheHeadingBeforeTheFirstTurn() {
        Flight flight;
        flight.noise = 0.05;
        for (int i = 0; i < 200; ++i)
            flight.tick({1, 0});
        QVERIFY(std::abs(flight.filter.correction_rad()) < radians(0.1));
    }

    void findsTheDriftOfManyTurns() {
        Flight flight;
        flight.noise = 0.05;
        double worst_raw_rad = 0.0;
        for (int lane = 0; lane < 40; ++lane) {
            flight.turn(lane % 2 == 0 ? pi / 2 : -pi / 2);
            flight.error_rad += radians(0.5); // drifts away for good
            for (int i = 0; i < 150; ++i)
                flight.tick({1, 0});
            worst_raw_rad = std::max(worst_raw_rad, std::abs(flight.error_rad));
            QVERIFY(std::abs(flight.remaining_rad()) < radians(1.5));
        }
        QVERIFY(worst_raw_rad > radians(10.0));
    }

    void isNoSurerForHearingTwiceAsOften() {
        Flight usual;
        Flight udk;
        udk.tick_s = 0.1;
        for (Flight* flight : {&usual, &udk}) {
            flight->turn(pi / 2);
            flight->turn(-pi / 2);
            flight->error_rad = radians(2.0);
            for (Seconds end = flight->now + Seconds(1.85); flight->now < end;)
                flight->tick({0.6, 0});
        }
        QVERIFY(usual.filter.correction_rad() < 0.0);
        QVERIFY(std::abs(usual.filter.correction_rad() - udk.filter.correction_rad()) < radians(0.05));
    }

    void allowsForFlightAside_data() {
        QTest::addColumn<double>("forward_m_s");
        QTest::addColumn<double>("left_m_s");
        QTest::newRow("ahead") << 1.0 << 0.0;
        QTest::newRow("crabbing") << 0.8 << 0.4;
        QTest::newRow("backward") << -0.8 << 0.1;
    }
    void allowsForFlightAside() {
        QFETCH(double, forward_m_s);
        QFETCH(double, left_m_s);
        Flight flight;
        flight.turn(pi / 2);
        flight.turn(-pi / 2);
        flight.error_rad = radians(2.0);
        for (int i = 0; i < 300; ++i)
            flight.tick({forward_m_s, left_m_s});
        QVERIFY(std::abs(flight.remaining_rad()) < radians(0.3));
    }

    void learnsNothingFromAFlightThatIsNotSteady() {
        Flight flight;
        flight.turn(pi / 2);
        flight.error_rad = radians(3.0);
        for (int i = 0; i < 200; ++i)
            flight.tick({i % 4 < 2 ? 1.0 : 0.4, 0.0});
        QCOMPARE(flight.filter.correction_rad(), 0.0);
    }

    void learnsNothingFromSlowFlightOrFromStandingStill() {
        Flight flight;
        flight.turn(pi / 2);
        flight.error_rad = radians(3.0);
        for (int i = 0; i < 200; ++i)
            flight.tick({0.3, 0.0});
        for (int i = 0; i < 200; ++i)
            flight.tick({1.0, 0.0}, false);
        QCOMPARE(flight.filter.correction_rad(), 0.0);
    }

    void takesNothingForDriftThatCannotBe() {
        Flight flight;
        flight.turn(pi / 2);
        flight.error_rad = radians(90.0); // pushed aside, or a command that was not obeyed
        for (int i = 0; i < 200; ++i)
            flight.tick({1.0, 0.0});
        QCOMPARE(flight.filter.correction_rad(), 0.0);
    }

    void forgetsWhenReset() {
        Flight flight;
        flight.turn(pi / 2);
        flight.error_rad = radians(3.0);
        for (int i = 0; i < 200; ++i)
            flight.tick({1.0, 0.0});
        QVERIFY(flight.filter.correction_rad() < radians(-2.0));
        flight.filter.reset();
        QCOMPARE(flight.filter.correction_rad(), 0.0);
    }
};

USAR_TEST(tst_CourseFilter)

} // namespace tst_course_filter

#include "tst_course_filter.moc"
