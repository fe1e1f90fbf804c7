#include "tests/robots/play_trial.h"
#include "tests/suite/suite.h"

namespace tst_ers_campaign {

using namespace usar;
using namespace usar::test;

class tst_ErsCampaign : public QObject {
    Q_OBJECT

private slots:
    void playsForFiveMinutes_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 10; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void playsForFiveMinutes() {
        QFETCH(int, seed);
        const Play played = play(static_cast<std::uint64_t>(seed), Seconds(300.0));
        QVERIFY(played.truth.first_touch.has_value());
        QCOMPARE(played.truth.falls, 0);
    }
};

USAR_TEST(tst_ErsCampaign)

} // namespace tst_ers_campaign

#include "tst_ers_campaign.moc"
