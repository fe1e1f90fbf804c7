// The ERS's missions that ship, run by the program for four minutes.
#include "tests/loop/shipped_mission.h"
#include "tests/suite/suite.h"

namespace tst_usar_ers {

using namespace usar::test;

class tst_UsarErs : public QObject {
    Q_OBJECT
private slots:
    void playsItsMissionsAndCountsWhatHappened_data() {
        QTest::addColumn<double>("soonest_s");
        QTest::newRow("ers_soccer") << 10.0;
        QTest::newRow("ers_search") << 20.0; // it has to turn around first
    }
    void playsItsMissionsAndCountsWhatHappened() {
        QFETCH(double, soonest_s);
        const EndedMission ended = runShipped(QTest::currentDataTag(), {{"play_time_s", 240}});
        QVERIFY2(ended.exit_code == 0, ended.said);
        QCOMPARE(ended.summary["behavior"].toString(), QString("ers/cpp"));
        QVERIFY2(ended.summary["reason"].toString().startsWith("Played for 240 s"), ended.said);
        QCOMPARE(ended.summary["falls"].toInt(-1), 0);
        QVERIFY2(ended.summary["touches"].toInt() > 0, ended.said);
        const double first_s = ended.summary["first_touch_s"].toDouble();
        QVERIFY2(first_s > soonest_s && first_s < 240.0, ended.said);
        QVERIFY(ended.summary["least_height_m"].isNull());
    }
};

USAR_TEST(tst_UsarErs)

} // namespace tst_usar_ers

#include "tst_usar_ers.moc"
