#include <QObject>
#include <QTest>

#include "tests/sim/two_robots.h"
#include "tests/suite/suite.h"

namespace tst_same_bytes {

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

USAR_TEST(tst_SameBytes)

} // namespace tst_same_bytes

#include "tst_same_bytes.moc"
