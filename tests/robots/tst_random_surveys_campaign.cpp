#include <QTest>

#include "tests/robots/random_survey.h"
#include "tests/suite/suite.h"

namespace tst_random_surveys_campaign {

using namespace usar;

class tst_RandomSurveysCampaign : public QObject {
    Q_OBJECT

private slots:
    void endsByItselfAndWhole_data() { test::surveyRows(20, 1000); }
    void endsByItselfAndWhole() {
        QFETCH(int, number);
        test::tryRandomSurvey(number);
    }
};

USAR_TEST(tst_RandomSurveysCampaign)

} // namespace tst_random_surveys_campaign

#include "tst_random_surveys_campaign.moc"
