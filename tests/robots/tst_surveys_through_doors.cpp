#include <QTest>

#include "tests/robots/random_survey.h"
#include "tests/suite/suite.h"

namespace tst_surveys_through_doors {

using namespace usar;

class tst_SurveysThroughDoors : public QObject {
    Q_OBJECT

    /// Flies the surveys, none of which may break, and at least `at_least` of which must be well.
    template <class IsWell>
    static void flyAll(const QList<int>& numbers, int at_least, IsWell is_well) {
        int well = 0;
        for (const int number : numbers) {
            const test::SurveyOutcome outcome = test::fly(test::drawSurvey(number));
            QVERIFY2(!outcome.broken, outcome.text().c_str());
            well += is_well(outcome) ? 1 : 0;
        }
        QVERIFY2(well >= at_least, qPrintable(QString::number(well)));
    }

private slots:
    // 43 of 46 surveys of a hall from its dock scanned it.
    void scansBehindDoorsThatAreLowerThanItFlies_data() {
        QTest::addColumn<QList<int>>("numbers");
        QTest::newRow("by POSH") << QList<int>{165837, 166285, 166557};
        QTest::newRow("by C++") << QList<int>{821, 165637, 166757};
    }
    void scansBehindDoorsThatAreLowerThanItFlies() {
        QFETCH(QList<int>, numbers);
        flyAll(numbers, /*at_least=*/2,
               [](const test::SurveyOutcome& outcome) { return outcome.reachable_coverage_pct.value_or(0.0) >= 96.0; });
    }

    // It sank and climbed before a wall until it gave its goals up as late, or found no way home among shelves. Which
    // aisle it finds is luck, so that one of three may fail.
    void comesHomeThroughADoor_data() {
        QTest::addColumn<QList<int>>("numbers");
        QTest::newRow("to the hall and back, by POSH") << QList<int>{98349, 98397, 98493};
        QTest::newRow("to the hall and back, by C++") << QList<int>{98181, 98229, 98469};
    }
    void comesHomeThroughADoor() {
        QFETCH(QList<int>, numbers);
        flyAll(numbers, /*at_least=*/2, [](const test::SurveyOutcome& outcome) {
            return outcome.success && outcome.reachable_coverage_pct.value_or(0.0) >= 97.0;
        });
    }

    // It passed a door as it was to land in need, and the plan waited for a landing that the flight had given up.
    void endsIfItPassesADoorAsItLands() {
        const test::SurveyOutcome outcome = test::fly(test::drawSurvey(163933));
        QVERIFY2(outcome.ended && !outcome.broken, outcome.text().c_str());
    }
};

USAR_TEST(tst_SurveysThroughDoors)

} // namespace tst_surveys_through_doors

#include "tst_surveys_through_doors.moc"
