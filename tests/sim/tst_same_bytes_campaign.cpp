#include <QObject>
#include <QTest>

#include "tests/sim/two_robots.h"
#include "tests/suite/suite.h"

namespace tst_same_bytes_campaign {

using namespace usar::sim;

class tst_SameBytesCampaign : public QObject {
    Q_OBJECT

private slots:
    void tenMinutesOfTwoRobotsAreTheSameFromOneSeed() {
        QVERIFY(heardByTwoRobots(7, 3000) == heardByTwoRobots(7, 3000));
    }
};

USAR_TEST(tst_SameBytesCampaign)

} // namespace tst_same_bytes_campaign

#include "tst_same_bytes_campaign.moc"
