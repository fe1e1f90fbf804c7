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

    void scansWhatLanesAloneDoNotShow() {
        const test::SurveyOutcome outcome = test::fly(test::drawSurvey(809)); // between shelves and walls
        QVERIFY2(!outcome.broken && outcome.reachable_coverage_pct.value_or(0.0) >= 96.0, outcome.text().c_str());
    }

    // Its commands come 1.6 s late. It once swung from side to side, took that for ceilings, and broke after 26 min.
    void scansOverALateLink() {
        const test::SurveyOutcome outcome = test::fly(test::drawFaultySurvey(4006));
        QVERIFY2(outcome.success && outcome.collisions == 0 && outcome.elapsed_s < 900.0, outcome.text().c_str());
    }

    // It flew on until the echo of its motion told it, or took the backlog of a silent link for a ceiling.
    void staysWholeOverALinkThatGetsLateOrSilent_data() {
        QTest::addColumn<int>("number");
        QTest::newRow("late by 2.4 s both ways, between the walls of a quarry") << 87007;
        QTest::newRow("silent for 16 s, among the houses of a town") << 87062;
    }
    void staysWholeOverALinkThatGetsLateOrSilent() {
        QFETCH(int, number);
        const test::SurveyOutcome outcome = test::fly(test::drawFaultySurvey(number));
        QVERIFY2(outcome.success && !outcome.broken, outcome.text().c_str());
    }

    // It looked for a way, or for a place to which nothing stood in the way, until its battery was empty, and fell.
    void landsBeforeItsBatteryIsEmpty_data() {
        QTest::addColumn<int>("number");
        QTest::newRow("it is in a room, and its battery fails on the lanes") << 126105;
        QTest::newRow("shelves keep it from all places") << 80093;
    }
    void landsBeforeItsBatteryIsEmpty() {
        QFETCH(int, number);
        const test::SurveyOutcome outcome = test::fly(test::drawFaultySurvey(number));
        QVERIFY2(outcome.ended && !outcome.broken && outcome.height_m < 0.1, outcome.text().c_str());
    }

    // It had found room to climb beside the ground of a small field, and came down where there was none.
    void comesDownWhereThereIsGround_data() {
        QTest::addColumn<int>("number");
        QTest::newRow("its climb began beyond the end of the ground") << 158228;
        QTest::newRow("the same at another corner") << 158948;
        QTest::newRow("its climb began just beside the end of the ground") << 157164;
    }
    void comesDownWhereThereIsGround() {
        QFETCH(int, number);
        const test::SurveyOutcome outcome = test::fly(test::drawSurvey(number));
        QVERIFY2(outcome.success && outcome.collisions == 0, outcome.text().c_str());
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
