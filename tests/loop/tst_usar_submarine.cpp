// The Submarine's mission that ships, run by the program for five minutes.
#include "tests/loop/shipped_mission.h"
#include "tests/suite/suite.h"

namespace tst_usar_submarine {

using namespace usar::test;

class tst_UsarSubmarine : public QObject {
    Q_OBJECT
private slots:
    void divesItsMissionAndCountsWhatHappened() {
        const EndedMission ended = runShipped("submarine_sea", {{"dive_time_s", 300}});
        QVERIFY2(ended.exit_code == 0, ended.said);
        QCOMPARE(ended.summary["behavior"].toString(), QString("submarine/cpp"));
        QVERIFY2(ended.summary["reason"].toString().startsWith("Dived for 300 s"), ended.said);
        QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
        QVERIFY2(ended.summary["true_distance_m"].toDouble() > 200.0, ended.said);
        QVERIFY2(ended.summary["least_height_m"].toDouble() > 0.5, ended.said);
        const double mean_m = ended.summary["mean_height_m"].toDouble();
        QVERIFY2(mean_m > 3.0 && mean_m < 8.0, ended.said); // the way down counts
        QVERIFY(ended.summary["first_touch_s"].isNull());
    }

    void waitsWhileItsRayIsSilent() {
        const EndedMission ended = runShipped("submarine_sea", {{"dive_time_s", 120}},
                                              {"--fault", "sensor_dropout robot=R1 sensor=Laser from=40 for=60"});
        QVERIFY2(ended.exit_code == 0, ended.said);
        QVERIFY2(ended.said.contains("The ray on the belly is silent"), ended.said);
        QVERIFY2(ended.summary["longest_stay_s"].toDouble() > 20.0, ended.said); // it brakes and hovers
        QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
    }
};

USAR_TEST(tst_UsarSubmarine)

} // namespace tst_usar_submarine

#include "tst_usar_submarine.moc"
