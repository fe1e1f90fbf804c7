#include "tests/robots/survey_trial.h"
#include "tests/suite/suite.h"

namespace tst_survey_campaign {

using namespace usar;

class tst_SurveyCampaign : public QObject {
    Q_OBJECT

private slots:
    void mapsTheMeadowTenTimes_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 10; ++seed)
            QTest::newRow(qPrintable(QString("seed %1").arg(seed))) << seed;
    }
    void mapsTheMeadowTenTimes() {
        QFETCH(int, seed);
        test::trySurvey(static_cast<std::uint64_t>(seed), {Vec2(-30, -20), Vec2(30, 20)}, Seconds(1200));
    }

    void mapsAllOfTallTest_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 3; ++seed)
            QTest::newRow(qPrintable(QString("seed %1").arg(seed))) << seed;
    }
    void mapsAllOfTallTest() {
        QFETCH(int, seed);
        test::trySurvey(static_cast<std::uint64_t>(seed), {Vec2(-100, -100), Vec2(100, 100)}, Seconds(15000));
    }
};

USAR_TEST(tst_SurveyCampaign)

} // namespace tst_survey_campaign

#include "tst_survey_campaign.moc"
