#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/flight/steering.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_steering {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Steering : public QObject {
    Q_OBJECT

    const WayNeeded needed{1.2, 3.5};

private slots:
    void fliesStraightWhereNothingIs() {
        Steering steering;
        const auto bearing = steering.choose({}, {0, 0}, {0, 10}, 4.8, needed);
        QVERIFY(bearing && std::abs(*bearing - pi / 2.0) < 1e-9);
    }

    void goesRoundWhatStandsInTheWay() {
        Steering steering;
        const std::vector<Obstacle> tree{wallAt(2.5, 0.0)};
        const auto bearing = steering.choose(tree, {0, 0}, {10, 0}, 4.8, needed);
        QVERIFY(bearing);
        QVERIFY(clearance_m(tree, {0, 0}, *bearing, needed.half_width_m, needed.length_m) >= needed.length_m);
        QVERIFY(std::abs(*bearing) < radians(60.0));
    }

    void keepsTheSideThatItChose() {
        Steering steering;
        const auto first = steering.choose(std::vector{wallAt(2.5, -0.1)}, {0, 0}, {10, 0}, 4.8, needed);
        const auto second = steering.choose(std::vector{wallAt(2.5, 0.1)}, {0, 0}, {10, 0}, 4.8, needed);
        QVERIFY(first && second);
        QVERIFY(*first * *second > 0.0);
    }

    void needsNoRoomBeyondTheGoal() {
        Steering steering;
        const auto bearing = steering.choose(std::vector{wallAt(3.0, 0.0)}, {0, 0}, {1.5, 0}, 4.8, needed);
        QVERIFY(bearing && std::abs(*bearing) < 1e-9);
    }

    void fliesOverAKnownTopThatTheClimbWillHavePassed_data() {
        QTest::addColumn<double>("top_m");
        QTest::addColumn<bool>("known");
        QTest::addColumn<bool>("straight");
        QTest::newRow("a little higher, known") << 5.5 << true << true;
        QTest::newRow("much higher, known") << 9.0 << true << false;
        QTest::newRow("a little higher, only a sonar saw it") << 5.5 << false << false;
    }
    void fliesOverAKnownTopThatTheClimbWillHavePassed() {
        QFETCH(double, top_m);
        QFETCH(bool, known);
        QFETCH(bool, straight);
        Steering steering;
        const auto bearing = steering.choose(std::vector{wallAt(2.5, 0, top_m, known)}, {0, 0}, {10, 0}, 4.8, needed);
        QVERIFY(bearing);
        QCOMPARE(std::abs(*bearing) < 1e-9, straight);
    }

    void saysWhenAllWaysAreBlocked() {
        Steering steering;
        std::vector<Obstacle> ring;
        for (int i = 0; i < 36; ++i)
            ring.push_back(wallAt(2.0 * std::cos(i * pi / 18.0), 2.0 * std::sin(i * pi / 18.0)));
        QVERIFY(!steering.choose(ring, {0, 0}, {10, 0}, 4.8, needed));
    }

    void stopsWithinItsFreeWay_data() {
        QTest::addColumn<double>("free_m");
        for (const double free_m : {0.1, 0.5, 1.0, 3.0, 8.0})
            QTest::newRow(qPrintable(QString("%1 m").arg(free_m))) << free_m;
    }
    void stopsWithinItsFreeWay() {
        QFETCH(double, free_m);
        const double speed_m_s = stoppingSpeed_m_s(free_m, 1.0, 0.4);
        const double needed_m = speed_m_s * 0.4 + speed_m_s * speed_m_s / 2.0;
        QVERIFY(std::abs(needed_m - free_m) < 1e-9); // the fastest that still stops
    }

    void standsStillWithoutRoom() {
        QCOMPARE(stoppingSpeed_m_s(0.0, 1.0), 0.0);
        QCOMPARE(stoppingSpeed_m_s(-1.0, 1.0), 0.0);
    }
};

USAR_TEST(tst_Steering)

} // namespace tst_steering

#include "tst_steering.moc"
