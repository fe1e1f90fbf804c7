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

    /// A robot that does what it is told, as far as the wind lets it; its INS is off by `error_rad`.
    struct Flight {
        CourseFilter filter;
        Random random{5};
        double true_yaw_rad = 0.0;
        double error_rad = 0.0;
        double noise = 0.0;
        Vec2 wind_m_s = Vec2::Zero(); ///< what it adds to the velocity, map frame
        Vec2 at_m = Vec2::Zero();
        double tick_s = 0.2;
        Seconds now{50.0};

        void tick(const Vec2& commanded_m_s, bool moves = true) {
            const Vec2 velocity_m_s = Eigen::Rotation2Dd(true_yaw_rad) * commanded_m_s + wind_m_s;
            const Vec2 step_m = velocity_m_s * (moves ? tick_s : 0.0);
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
        /// It has seen before its first turn that there is no wind.
        void beginInCalmAir() {
            for (int i = 0; i < 50; ++i)
                tick({1, 0});
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
            for (Seconds end = flight->now + Seconds(9.95); flight->now < end;)
                flight->tick({0.6, 0});
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
        flight.beginInCalmAir();
        flight.turn(pi / 2);
        flight.turn(-pi / 2);
        flight.error_rad = radians(2.0);
        for (int i = 0; i < 300; ++i)
            flight.tick({forward_m_s, left_m_s});
        QVERIFY(std::abs(flight.remaining_rad()) < radians(0.5));
    }

    void learnsNothingFromAFlightThatIsNotSteady() {
        Flight flight;
        flight.beginInCalmAir();
        flight.turn(pi / 2);
        flight.error_rad = radians(3.0);
        const double before_rad = flight.filter.correction_rad();
        for (int i = 0; i < 200; ++i)
            flight.tick({i % 4 < 2 ? 1.0 : 0.4, 0.0});
        QCOMPARE(flight.filter.correction_rad(), before_rad);
    }

    void learnsNothingWhereTheRobotMayNotObey() {
        Flight flight;
        flight.beginInCalmAir();
        flight.turn(pi / 2);
        for (int i = 0; i < 200; ++i) {
            flight.now += Seconds(flight.tick_s);
            flight.at_m += Vec2(0.1, 0.1);
            flight.filter.update(flight.now, {Vec3(flight.at_m.x(), flight.at_m.y(), 0.2), 0, 0, flight.true_yaw_rad},
                                 std::nullopt);
        }
        QVERIFY(std::abs(flight.remaining_rad()) < radians(3.0));
        QVERIFY(flight.filter.wind_m_s().norm() < 0.05);
    }

    void takesNothingForDriftThatCannotBe_data() {
        QTest::addColumn<double>("error_rad");
        QTest::addColumn<bool>("moves");
        QTest::newRow("held") << 0.0 << false;
        QTest::newRow("pushed aside") << radians(90.0) << true;
    }
    void takesNothingForDriftThatCannotBe() {
        QFETCH(double, error_rad);
        QFETCH(bool, moves);
        Flight flight;
        flight.beginInCalmAir();
        flight.turn(pi / 2);
        flight.error_rad = error_rad;
        for (int i = 0; i < 200; ++i)
            flight.tick({1.0, 0.0}, moves);
        QVERIFY(std::abs(flight.filter.correction_rad()) < radians(3.0));
    }

    void tellsWindFromDrift_data() {
        QTest::addColumn<Vec2>("wind_m_s");
        QTest::addColumn<double>("most_rad");
        QTest::newRow("calm") << Vec2(0, 0) << radians(2.0);
        QTest::newRow("along the lanes") << Vec2(0.3, 0) << radians(8.0);
        QTest::newRow("across the lanes") << Vec2(0, 0.3) << radians(8.0);
        QTest::newRow("strong") << Vec2(-0.5, 0.6) << radians(8.0);
    }
    void tellsWindFromDrift() {
        QFETCH(Vec2, wind_m_s);
        QFETCH(double, most_rad);
        Flight flight;
        flight.noise = 0.05;
        flight.wind_m_s = wind_m_s;
        double worst_rad = 0.0;
        for (int lane = 0; lane < 30; ++lane) {
            flight.turn(lane % 4 < 2 ? pi / 2 : -pi / 2);
            flight.error_rad += radians(0.5);
            for (int i = 0; i < 150; ++i) {
                flight.tick({1, 0});
                if (lane > 3 && i > 75)
                    worst_rad = std::max(worst_rad, std::abs(flight.remaining_rad()));
            }
        }
        QVERIFY(flight.error_rad > radians(5.0));
        QVERIFY2(worst_rad < most_rad, qPrintable(QString::number(worst_rad)));
        QVERIFY((flight.filter.wind_m_s() - wind_m_s).norm() < 0.05 + 0.15 * wind_m_s.norm());
    }

    void findsAWindThatRises() {
        Flight flight;
        flight.noise = 0.05;
        flight.beginInCalmAir();
        flight.wind_m_s = {0.2, 0.8};
        for (int i = 0; i < 100; ++i)
            flight.tick({1, 0});
        QVERIFY((flight.filter.wind_m_s() - flight.wind_m_s).norm() < 0.1);
        QVERIFY(std::abs(flight.filter.correction_rad()) < radians(1.0));
    }

    void forgetsTheDriftWhenTheInsIsSet() {
        Flight flight;
        flight.wind_m_s = {0.2, 0.1};
        for (int i = 0; i < 6; ++i) {
            flight.turn(pi / 2);
            for (int k = 0; k < 100; ++k)
                flight.tick({1, 0});
        }
        QVERIFY(std::abs(flight.filter.correction_rad()) > 0.0);
        flight.filter.insWasSet();
        QCOMPARE(flight.filter.correction_rad(), 0.0);
        QVERIFY((flight.filter.wind_m_s() - flight.wind_m_s).norm() < 0.1); // It still blows.
    }
};

USAR_TEST(tst_CourseFilter)

} // namespace tst_course_filter

#include "tst_course_filter.moc"
