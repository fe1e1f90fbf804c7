#include "tests/robots/survey_trial.h"

using namespace usar;

class TestQuickScan : public QObject {
    Q_OBJECT

private slots:
    void mapsTheMeadowWithoutTouchingATree_data() {
        QTest::addColumn<int>("seed");
        for (const int seed : {1, 2, 3})
            QTest::newRow(qPrintable(QString("seed %1").arg(seed))) << seed;
    }
    void mapsTheMeadowWithoutTouchingATree() {
        QFETCH(int, seed);
        tests::trySurvey(static_cast<std::uint64_t>(seed), {Vec2(-30, -20), Vec2(30, 20)}, Seconds(1200));
    }
};

QTEST_APPLESS_MAIN(TestQuickScan)
#include "tst_quick_scan.moc"
