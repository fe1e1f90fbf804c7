#include <QObject>
#include <QTest>

#include "robots/airrobot/settings.h"
#include "tests/suite/suite.h"

namespace tst_settings {

using namespace usar;
using namespace usar::agent;
using namespace usar::airrobot;

class tst_Settings : public QObject {
    Q_OBJECT

private slots:
    void hasDefaultsThatItsOwnRangesAccept() {
        std::map<std::string, ParameterValue> defaults;
        for (const ParameterSpec& spec : Settings::parameters.specs())
            defaults[spec.id] = spec.default_value;
        const auto set = ParameterSet::make(Settings::parameters.specs(), defaults);
        QVERIFY2(set, set ? "" : set.error().text().c_str());
        QVERIFY(Settings::parameters.settings(*set) == Settings{});
    }

    void describesEveryParameterInFull() {
        for (const ParameterSpec& spec : Settings::parameters.specs()) {
            QVERIFY2(!spec.label.empty() && !spec.group.empty() && !spec.help.empty(), spec.id.c_str());
            QVERIFY2(spec.help.ends_with('.'), spec.id.c_str());
            if (!std::holds_alternative<bool>(spec.default_value))
                QVERIFY2(spec.minimum < spec.maximum, spec.id.c_str());
        }
    }

    void namesTheUnitInTheId() {
        const std::map<std::string, std::string> suffixes{{"m", "_m"},         {"m/s", "_m_s"}, {"s", "_s"},
                                                          {"rad/s", "_rad_s"}, {"rad", "_rad"}, {"%", "_pct"},
                                                          {"m/s²", "_m_s2"}};
        for (const ParameterSpec& spec : Settings::parameters.specs())
            if (!spec.unit.empty())
                QVERIFY2(spec.id.ends_with(suffixes.at(spec.unit)), spec.id.c_str());
    }

    void putsEveryValueWhereItBelongs() {
        const auto set = ParameterSet::make(Settings::parameters.specs(), {{"scan_altitude_m", 7.5},
                                                                           {"calm_cycles", 9LL},
                                                                           {"climb_over", false},
                                                                           {"low_risk_3_m", 1.75},
                                                                           {"battery_range_m", 500.0}});
        QVERIFY(set);
        const Settings settings = Settings::parameters.settings(*set);
        QCOMPARE(settings.scan_altitude_m, 7.5);
        QCOMPARE(settings.calm_cycles, 9);
        QCOMPARE(settings.climb_over, false);
        QCOMPARE(settings.lowRisk_m(3), 1.75);
        QCOMPARE(settings.battery_range_m, 500.0);
        QCOMPARE(settings.scan_speed_m_s, Settings{}.scan_speed_m_s);
    }

    /// By hand: at 6 m and 0.5 m, the outermost beam is 62.8 degrees from straight down and meets the ground 11.7 m
    /// aside.
    void followsWhatTheMapShallShow_data() {
        QTest::addColumn<double>("resolution_m");
        QTest::addColumn<double>("overlap_pct");
        QTest::addColumn<double>("altitude_m");
        QTest::addColumn<double>("spacing_m");
        QTest::addColumn<double>("speed_m_s");
        QTest::newRow("half a meter") << 0.5 << 25.0 << 6.0 << 17.5 << 2.0;
        QTest::newRow("without an overlap") << 0.5 << 0.0 << 6.0 << 23.3 << 2.0;
        QTest::newRow("finer") << 0.25 << 25.0 << 6.0 << 10.6 << 1.25;
        QTest::newRow("lower") << 0.5 << 25.0 << 3.0 << 13.2 << 2.0;
        QTest::newRow("finer than the beams straight down") << 0.15 << 25.0 << 15.0 << 2.0 << 0.75;
        QTest::newRow("as far as the scanner reaches") << 2.0 << 0.0 << 15.0 << 23.3 << 2.0;
    }
    void followsWhatTheMapShallShow() {
        QFETCH(double, resolution_m);
        QFETCH(double, overlap_pct);
        QFETCH(double, altitude_m);
        QFETCH(double, spacing_m);
        QFETCH(double, speed_m_s);
        Settings settings;
        settings.lane_spacing_m = settings.scan_speed_m_s = Settings::by_resolution;
        settings.ground_resolution_m = resolution_m;
        settings.overlap_pct = overlap_pct;
        settings.scan_altitude_m = altitude_m;
        const Settings asked = settings.asAsked();
        QVERIFY2(std::abs(asked.lane_spacing_m - spacing_m) < 0.1, qPrintable(QString::number(asked.lane_spacing_m)));
        QVERIFY(std::abs(asked.scan_speed_m_s - speed_m_s) < 1e-9);
        QVERIFY(asked.asAsked() == asked);
        QVERIFY(asked.lane_spacing_m <
                2.0 * std::sqrt(20.0 * 20.0 - altitude_m * altitude_m)); // No stripe is out of reach.
    }

    /// 16 times the resolution, within what the robot may fly and the scanner reaches.
    void fliesAsHighAsTheResolutionAsks_data() {
        QTest::addColumn<double>("resolution_m");
        QTest::addColumn<double>("altitude_m");
        QTest::addColumn<double>("spacing_m");
        QTest::newRow("half a meter") << 0.5 << 8.0 << 19.3;
        QTest::newRow("finer") << 0.25 << 4.0 << 9.6;
        QTest::newRow("too fine to fly so low") << 0.15 << 2.5 << 5.7;
        QTest::newRow("coarse") << 2.0 << 10.0 << 24.2;
    }
    void fliesAsHighAsTheResolutionAsks() {
        QFETCH(double, resolution_m);
        QFETCH(double, altitude_m);
        QFETCH(double, spacing_m);
        Settings settings;
        settings.scan_altitude_m = settings.lane_spacing_m = Settings::by_resolution;
        settings.ground_resolution_m = resolution_m;
        const Settings asked = settings.asAsked();
        QVERIFY2(std::abs(asked.scan_altitude_m - altitude_m) < 0.11,
                 qPrintable(QString::number(asked.scan_altitude_m)));
        QVERIFY2(std::abs(asked.lane_spacing_m - spacing_m) < 0.1, qPrintable(QString::number(asked.lane_spacing_m)));
        QVERIFY(asked.asAsked() == asked);
        settings.scan_altitude_m = 1.0; // It is not flown lower than this.
        QCOMPARE(settings.asAsked().scan_altitude_m, 2.0);
    }

    void leavesWhatAPersonSet() {
        Settings settings;
        settings.lane_spacing_m = 9.0;
        settings.scan_speed_m_s = 1.0;
        QVERIFY(settings.asAsked() == settings);
    }

    void shapesTheZonesAsTheThesisDraws() {
        const Settings settings;
        for (std::size_t ring = 0; ring < 5; ++ring)
            QVERIFY(settings.highRisk_m(ring) < settings.lowRisk_m(ring));
        for (std::size_t ring = 1; ring < 5; ++ring) { // long in front, short at the sides
            QVERIFY(settings.lowRisk_m(ring) < settings.lowRisk_m(ring - 1));
            QVERIFY(settings.highRisk_m(ring) < settings.highRisk_m(ring - 1));
        }
    }
};

USAR_TEST(tst_Settings)

} // namespace tst_settings

#include "tst_settings.moc"
