#include "tests/robots/play_trial.h"

using namespace usar;
using namespace usar::tests;

class TestErsCampaign : public QObject {
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

QTEST_APPLESS_MAIN(TestErsCampaign)
#include "tst_ers_campaign.moc"
