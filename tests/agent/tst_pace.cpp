// What the stages so far tell about those to come.
#include <cmath>

#include <QObject>
#include <QTest>

#include "core/agent/pace.h"
#include "core/base/random.h"
#include "tests/suite/suite.h"

namespace tst_pace {

using namespace usar;
using agent::Forecast;
using agent::Pace;

class tst_Pace : public QObject {
    Q_OBJECT

private slots:
    void knowsNothingButItsPriorAtFirst() {
        const Pace pace({1.2, 100.0, 2.0, 3.0});
        QCOMPARE(pace.pace(), 1.2);
        QCOMPARE(pace.scatter(), 2.0);
        const Forecast rest = pace.forecast(50.0);
        QCOMPARE(rest.mean, 60.0);
        QCOMPARE(rest.variance, 2.0 * 50.0 + 2.0 * 50.0 * 50.0 / 100.0);
    }

    /// By the formulas of the class, by hand.
    void takesInWhatWasMeasured() {
        Pace pace({1.0, 40.0, 1.0, 2.0});
        pace.note(20.0, 30.0);
        pace.note(20.0, 22.0);
        const double r = (40.0 + 52.0) / 80.0;
        const double residuals = (30 - r * 20) * (30 - r * 20) / 20.0 + (22 - r * 20) * (22 - r * 20) / 20.0;
        QVERIFY(std::abs(pace.pace() - r) < 1e-12);
        QVERIFY(std::abs(pace.scatter() - (1.0 * 2.0 + residuals) / 4.0) < 1e-12);
        QCOMPARE(pace.forecast(0.0).deviation(), 0.0);
    }

    void aStageOfNoLengthTeachesNothing() {
        Pace pace({1.1, 40.0, 1.0, 2.0});
        pace.note(0.0, 30.0);
        pace.note(std::nan(""), 30.0);
        QCOMPARE(pace.pace(), 1.1);
    }

    /// 400 tasks of 30 stages of 20 s, which take 1.3 times as long with a scatter; judged after six.
    void fourOfFiveEndsLieInTheRange() {
        Random random = seeded(5, 1);
        int held = 0;
        for (int task = 0; task < 400; ++task) {
            Pace pace({1.1, 60.0, 2.0, 3.0});
            const auto stage = [&] { return 26.0 + gaussian(random, 7.0); };
            for (int i = 0; i < 6; ++i)
                pace.note(20.0, stage());
            double really = 0.0;
            for (int i = 6; i < 30; ++i)
                really += stage();
            const TimeRange range = pace.forecast(24 * 20.0).range();
            held += range.least.count() <= really && really <= range.most.count() ? 1 : 0;
        }
        QVERIFY2(held > 280 && held < 360, qPrintable(QString::number(held)));
    }

    void aRangeIsNeverBeforeNow() {
        const TimeRange range = Forecast{5.0, 100.0}.range();
        QCOMPARE(range.least.count(), 0.0);
        QVERIFY(range.most > Seconds(17.0) && range.most < Seconds(18.0));
    }
};

USAR_TEST(tst_Pace)

} // namespace tst_pace

#include "tst_pace.moc"
