#include <QTest>

#include "tests/robots/random_survey.h"
#include "tests/suite/suite.h"

namespace tst_random_surveys_campaign {

using namespace usar;

class tst_RandomSurveysCampaign : public QObject {
    Q_OBJECT

private slots:
    void endsByItselfAndWhole_data() { test::surveyRowsOrAsked(20, 1000); }
    void endsByItselfAndWhole() {
        QFETCH(int, number);
        test::tryRandomSurvey(number);
    }

    /// By a preset that flies at 2 m/s.
    void inAHurryEndsByItselfAndWhole_data() { test::surveyRowsOrAsked(20, 420); }
    void inAHurryEndsByItselfAndWhole() {
        QFETCH(int, number);
        test::tryRandomSurvey(number, "balanced");
    }

    void tellsTheTruthOfAFault_data() { test::surveyRowsOrAsked(1000, 1500); }
    void tellsTheTruthOfAFault() {
        QFETCH(int, number);
        could_fly_ += test::drawFaultySurvey(number).fault->can_fly ? 1 : 0;
        crashes_ += test::tryFaultySurvey(number) ? 1 : 0;
    }

    void crashesRarelyWhereItCanFly() {
        qInfo("%d of %d that could fly crashed", crashes_, could_fly_);
        QVERIFY(50 * crashes_ <= could_fly_);
    }

private:
    int could_fly_ = 0;
    int crashes_ = 0;
};

USAR_TEST(tst_RandomSurveysCampaign)

} // namespace tst_random_surveys_campaign

#include "tst_random_surveys_campaign.moc"
