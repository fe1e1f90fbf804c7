#include "tests/robots/dive_trial.h"
#include "tests/suite/suite.h"

namespace tst_submarine_campaign {

using namespace usar;
using namespace usar::test;

class tst_SubmarineCampaign : public QObject {
    Q_OBJECT

private slots:
    void divesForHalfAnHour_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 10; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void divesForHalfAnHour() {
        QFETCH(int, seed);
        const Dive dived = diveInTheSea(static_cast<std::uint64_t>(seed), Seconds(1800.0));
        QVERIFY(dived.ending && dived.ending->success);
        QCOMPARE(dived.truth.collisions, 0);
        QVERIFY(dived.share_near_pct > 85.0);
        QVERIFY(dived.rms_error_m < 1.5);
        QVERIFY(dived.truth.distance_m > 1000.0);
    }
};

USAR_TEST(tst_SubmarineCampaign)

} // namespace tst_submarine_campaign

#include "tst_submarine_campaign.moc"
