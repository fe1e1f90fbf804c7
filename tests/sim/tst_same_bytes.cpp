#include <QtTest>

#include "tests/sim/two_robots.h"

using namespace usar::sim;

class tst_SameBytes : public QObject {
    Q_OBJECT

private slots:
    void aMinuteOfTwoRobotsIsTheSameFromOneSeed() {
        const std::string first = heardByTwoRobots(7, 300);
        QVERIFY(first.size() > 200'000);
        QVERIFY(first == heardByTwoRobots(7, 300));
        QVERIFY(first != heardByTwoRobots(8, 300));
    }
};

QTEST_GUILESS_MAIN(tst_SameBytes)
#include "tst_same_bytes.moc"
