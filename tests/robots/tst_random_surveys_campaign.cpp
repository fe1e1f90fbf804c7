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

    void tellsTheTruthOfAFault_data() { test::surveyRowsOrAsked(1000, 1500); }
    void tellsTheTruthOfAFault() {
        QFETCH(int, number);
        ++faulty_;
        crashes_ += test::tryFaultySurvey(number) ? 1 : 0;
    }

    void crashesRarelyWhereItCanFly() {
        qInfo("%d of %d crashed although they could fly", crashes_, faulty_);
        QVERIFY(50 * crashes_ <= faulty_);
    }

private:
    int faulty_ = 0;
    int crashes_ = 0;
};

USAR_TEST(tst_RandomSurveysCampaign)

} // namespace tst_random_surveys_campaign

#include "tst_random_surveys_campaign.moc"
