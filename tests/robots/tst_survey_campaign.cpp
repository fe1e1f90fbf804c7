#include "tests/robots/survey_trial.h"

using namespace usar;

class TestSurveyCampaign : public QObject {
    Q_OBJECT

private slots:
    void mapsTheMeadowTenTimes_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 10; ++seed)
            QTest::newRow(qPrintable(QString("seed %1").arg(seed))) << seed;
    }
    void mapsTheMeadowTenTimes() {
        QFETCH(int, seed);
        tests::trySurvey(static_cast<std::uint64_t>(seed), {Vec2(-30, -20), Vec2(30, 20)}, Seconds(1200));
    }

    void mapsAllOfTallTest_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 3; ++seed)
            QTest::newRow(qPrintable(QString("seed %1").arg(seed))) << seed;
    }
    void mapsAllOfTallTest() {
        QFETCH(int, seed);
        tests::trySurvey(static_cast<std::uint64_t>(seed), {Vec2(-100, -100), Vec2(100, 100)}, Seconds(15000));
    }
};

QTEST_APPLESS_MAIN(TestSurveyCampaign)
#include "tst_survey_campaign.moc"
