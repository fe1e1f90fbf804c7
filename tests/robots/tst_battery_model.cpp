#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/battery_model.h"
#include "tests/suite/suite.h"

namespace tst_battery_model {

using namespace usar;
using namespace usar::airrobot;

class tst_BatteryModel : public QObject {
    Q_OBJECT

private slots:
    void addsUpTheWayFlown() {
        BatteryModel battery;
        for (int i = 0; i <= 100; ++i)
            battery.moveTo({i * 0.2, 0, 0});
        QVERIFY(std::abs(battery.flown_m() - 20.0) < 1e-9);
        QVERIFY(std::abs(battery.used_pct(Settings{}) - 2.0) < 1e-9);
    }

    void addsNothingForTheNoiseOfStandingStill() {
        BatteryModel battery;
        for (int i = 0; i < 1000; ++i)
            battery.moveTo({i % 2 == 0 ? 0.0 : 0.01, 0, 0});
        QCOMPARE(battery.flown_m(), 0.0);
    }

    void countsSlowFlightInFull() {
        BatteryModel battery;
        for (int i = 0; i <= 1000; ++i)
            battery.moveTo({i * 0.01, 0, 0});
        QVERIFY(std::abs(battery.flown_m() - 10.0) < 0.05);
    }

    void keepsTheReserveAndTheWayHome_data() {
        QTest::addColumn<double>("home_m");
        QTest::addColumn<double>("left_m");
        QTest::newRow("over the base") << 0.0 << 85.0 - 30.0;
        QTest::newRow("far out") << 40.0 << 85.0 - 30.0 - 40.0;
        QTest::newRow("too far out") << 60.0 << 85.0 - 30.0 - 60.0;
    }
    void keepsTheReserveAndTheWayHome() {
        QFETCH(double, home_m);
        QFETCH(double, left_m);
        Settings settings;
        settings.battery_range_m = 100.0;
        BatteryModel battery;
        battery.moveTo({0, 0, 0});
        battery.moveTo({30, 0, 0});
        QVERIFY(std::abs(battery.rangeLeft_m(home_m, settings) - left_m) < 1e-9);
        QCOMPARE(battery.used_pct(settings), 30.0);
        QCOMPARE(battery.sinceCharge_m(), 30.0);
    }

    void beginsAnewAfterACharge() {
        BatteryModel battery;
        battery.moveTo({0, 0, 0});
        battery.moveTo({30, 0, 0});
        battery.recharge();
        QCOMPARE(battery.used_pct(Settings{}), 0.0);
        QCOMPARE(battery.flown_m(), 30.0);
        QCOMPARE(battery.charges(), 1);
    }

    void doesNotCountTheJumpOfAnInsReset() {
        BatteryModel battery;
        battery.moveTo({0, 0, 0});
        battery.forgetPosition();
        battery.moveTo({5, 5, 0});
        QCOMPARE(battery.flown_m(), 0.0);
    }

    void goesHomeInTimeForAllOfItsWay_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<bool>("low");
        QTest::newRow("low down, in still air") << 0.0 << 1.6 << false; // 41 s and the reserve of 60 s
        QTest::newRow("it has to sink, too") << 15.0 << 1.6 << true;
        QTest::newRow("against the wind") << 0.0 << 0.8 << true;
    }
    void goesHomeInTimeForAllOfItsWay() {
        QFETCH(double, height_m);
        QFETCH(double, speed_m_s);
        QFETCH(bool, low);
        QCOMPARE(isLow(Seconds(110.0), {50.0, height_m, speed_m_s}, Settings{}), low);
        QVERIFY(!isLow(std::nullopt, {50.0, height_m, speed_m_s}, Settings{}));
    }

    void usesAtMostAllOfIt() {
        Settings settings;
        settings.battery_range_m = 50.0;
        BatteryModel battery;
        battery.moveTo({0, 0, 0});
        battery.moveTo({80, 0, 0});
        QCOMPARE(battery.used_pct(settings), 100.0);
    }
};

USAR_TEST(tst_BatteryModel)

} // namespace tst_battery_model

#include "tst_battery_model.moc"
