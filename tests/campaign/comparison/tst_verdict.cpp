#include <QTest>

#include "core/campaign/comparison/verdict.h"
#include "tests/suite/suite.h"

namespace tst_verdict {

using namespace usar::campaign;

class tst_Verdict : public QObject {
    Q_OBJECT
private slots:
    void theWordIsThatOfThePieceOnWhichTheIntervalLies_data() {
        QTest::addColumn<Interval>("gain");
        QTest::addColumn<QString>("word");
        QTest::addColumn<bool>("not_worse");
        QTest::newRow("beyond the margin, good") << Interval{1.1, 3.0} << "better" << true;
        QTest::newRow("beyond the margin, bad") << Interval{-3.0, -1.1} << "worse" << false;
        QTest::newRow("significant but within the margin") << Interval{0.2, 0.9} << "equal" << true;
        QTest::newRow("significantly bad but within the margin") << Interval{-0.9, -0.2} << "equal" << true;
        QTest::newRow("from margin to margin") << Interval{-1.0, 1.0} << "equal" << true;
        QTest::newRow("beyond zero, around the margin") << Interval{0.5, 3.0} << "undecided" << true;
        QTest::newRow("beyond zero, around the bad margin") << Interval{-3.0, -0.5} << "undecided" << false;
        QTest::newRow("anything") << Interval{} << "undecided" << false;
    }
    void theWordIsThatOfThePieceOnWhichTheIntervalLies() {
        QFETCH(Interval, gain);
        QFETCH(QString, word);
        QFETCH(bool, not_worse);
        const Evidence evidence{gain, 1.0, true, true};
        QCOMPARE(QString(wordOf(verdictOn(evidence))), word);
        QCOMPARE(isNotWorse(evidence), not_worse);
    }

    void fewPairsDecideNothing() {
        for (const Interval& gain : {Interval{2.0, 3.0}, Interval{-3.0, -2.0}, Interval{0.0, 0.0}}) {
            QCOMPARE(verdictOn({gain, 1.0, false, true}), Verdict::Undecided);
            QVERIFY(!isNotWorse({gain, 1.0, false, true}));
        }
    }

    void withoutTheTestBesideItAnIntervalIsNoDifference() {
        QCOMPARE(verdictOn({{2.0, 3.0}, 1.0, true, false}), Verdict::Undecided);
        QCOMPARE(verdictOn({{-3.0, -2.0}, 1.0, true, false}), Verdict::Undecided);
        QCOMPARE(verdictOn({{-0.5, 0.5}, 1.0, true, false}), Verdict::Equal);
    }
};

USAR_TEST(tst_Verdict)

} // namespace tst_verdict

#include "tst_verdict.moc"
