#include <QtTest>

#include "tests/sim/two_robots.h"

using namespace usar::sim;

class tst_SameBytesCampaign : public QObject {
    Q_OBJECT

private slots:
    void tenMinutesOfTwoRobotsAreTheSameFromOneSeed() {
        QVERIFY(heardByTwoRobots(7, 3000) == heardByTwoRobots(7, 3000));
    }
};

QTEST_GUILESS_MAIN(tst_SameBytesCampaign)
#include "tst_same_bytes_campaign.moc"
