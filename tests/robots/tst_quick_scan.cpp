#include "tests/robots/survey_trial.h"
#include "tests/suite/suite.h"

namespace tst_quick_scan {

using namespace usar;

class tst_QuickScan : public QObject {
    Q_OBJECT

private slots:
    void mapsTheMeadowWithoutTouchingATree_data() {
        QTest::addColumn<int>("seed");
        QTest::addColumn<double>("tick_s");
        for (const int seed : {1, 2, 3})
            QTest::newRow(qPrintable(QString("seed %1").arg(seed))) << seed << 0.2;
        QTest::newRow("twice as many ticks, as UDK has") << 1 << 0.1;
    }
    void mapsTheMeadowWithoutTouchingATree() {
        QFETCH(int, seed);
        QFETCH(double, tick_s);
        test::trySurvey(static_cast<std::uint64_t>(seed), {Vec2(-30, -20), Vec2(30, 20)}, Seconds(1200),
                        Seconds(tick_s));
    }
};

USAR_TEST(tst_QuickScan)

} // namespace tst_quick_scan

#include "tst_quick_scan.moc"
