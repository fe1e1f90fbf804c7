#include <QTest>

#include "tests/robots/random_survey.h"
#include "tests/suite/suite.h"

namespace tst_random_surveys {

using namespace usar;

class tst_RandomSurveys : public QObject {
    Q_OBJECT

private slots:
    void endsByItselfAndWhole_data() { test::surveyRows(0, 13); }
    void endsByItselfAndWhole() {
        QFETCH(int, number);
        test::tryRandomSurvey(number);
    }

    void tellsTheTruthOfAFault_data() { test::surveyRows(13, 20); }
    void tellsTheTruthOfAFault() {
        QFETCH(int, number);
        QVERIFY(!test::tryFaultySurvey(number));
    }
};

USAR_TEST(tst_RandomSurveys)

} // namespace tst_random_surveys

#include "tst_random_surveys.moc"
