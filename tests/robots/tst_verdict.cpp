#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/verdict.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_verdict {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Verdict : public QObject {
    Q_OBJECT

    Settings settings;
    const Rectangle area{{0, 0}, {40, 20}};

    /// Two lanes, which are flown to their ends.
    Survey surveyDone(bool half_cut_off = false) const {
        mapping::CoveragePlan plan;
        plan.lanes = {{{0, 5}, {40, 5}, 0}, {{40, 15}, {0, 15}, 0}};
        plan.lane_length_m = 80.0;
        Survey survey(plan);
        if (half_cut_off)
            survey.cutOff(settings, [](const Vec2&) { return false; });
        while (!survey.done())
            survey.next(settings);
        return survey;
    }
    /// Scans on the lanes, half a meter apart: hits on the ground up to `seen_to_m` along x, and misses from there to
    /// `missed_to_m`.
    ScanLedger ledgerOf(double seen_to_m, double missed_to_m, int lost_ticks = 0) const {
        ScanLedger ledger(area);
        double now_s = 100.0;
        for (double x_m = 0.25; x_m < missed_to_m; x_m += 0.5) {
            Senses senses = sensesAt({x_m, 10.0, 6.0}, 0.0, now_s += 0.2);
            senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
            for (double y_m = 0.25; y_m < 20.0; y_m += 0.5) {
                const Vec3 ground_m(x_m, y_m, 0.0);
                if (x_m < seen_to_m)
                    senses.scan->hits_in_map_m.push_back(ground_m);
                else
                    senses.scan->misses_in_map_m.push_back(ground_m - Vec3(0.0, 0.0, 14.0));
            }
            ledger.note(senses, true, true);
        }
        for (int tick = 0; tick < lost_ticks; ++tick)
            ledger.note(sensesAt({0, 10, 6}, 0.0, now_s += 0.2), true, false);
        return ledger;
    }

    static double hiddenAfter(const Senses& senses, ScanLedger& ledger) {
        ledger.note(senses, true, true);
        return ledger.hiddenInSeen();
    }

private slots:
    void asksWhatTheScansShow_data() {
        QTest::addColumn<double>("seen_to_m");
        QTest::addColumn<double>("missed_to_m");
        QTest::addColumn<int>("lost_ticks");
        QTest::addColumn<bool>("half_cut_off");
        QTest::addColumn<QString>("words");
        QTest::newRow("all of the area") << 40.0 << 40.0 << 0 << false << "The area is scanned.";
        QTest::newRow("nearly all of it") << 38.5 << 38.5 << 0 << false << "The area is scanned.";
        QTest::newRow("nine tenths of it")
            << 36.0 << 36.0 << 0 << false << "The area is scanned; the scans show 90 % of it.";
        QTest::newRow("half of it") << 20.0 << 20.0 << 0 << false << "show only 50 % of the area";
        QTest::newRow("half of it, and deep water")
            << 20.0 << 40.0 << 0 << false << "scanned; below 48 % of it, no ground";
        QTest::newRow("deep water") << 0.0 << 40.0 << 0 << false << "hardly any ground";
        QTest::newRow("half of it, as far as ways lead") << 20.0 << 20.0 << 0 << true << "none was found to 40 m";
        QTest::newRow("a quarter of it, as far as ways lead") << 10.0 << 10.0 << 0 << true << "show only 25 %";
        QTest::newRow("all of it, with most scans lost") << 40.0 << 40.0 << 400 << false << "few scans of them came";
    }
    void asksWhatTheScansShow() {
        QFETCH(double, seen_to_m);
        QFETCH(double, missed_to_m);
        QFETCH(int, lost_ticks);
        QFETCH(bool, half_cut_off);
        QFETCH(QString, words);
        const auto verdict =
            verdictOf(surveyDone(half_cut_off), ledgerOf(seen_to_m, missed_to_m, lost_ticks), settings);
        QVERIFY2(QString::fromStdString(verdict.reason).contains(words), verdict.reason.c_str());
        QCOMPARE(verdict.success, verdict.reason.starts_with("The area is scanned"));
    }

    void tellsWhatItMissedWithinReach_data() {
        QTest::addColumn<double>("missed");
        QTest::addColumn<QString>("words");
        QTest::newRow("next to nothing") << 0.02 << "The area is scanned.";
        QTest::newRow("some") << 0.08 << "The area is scanned; no scan shows 8 % of the ground within reach.";
        QTest::newRow("much") << 0.19 << "no scan shows 19 % of the ground that the robot could have reached";
    }
    void tellsWhatItMissedWithinReach() {
        QFETCH(double, missed);
        QFETCH(QString, words);
        const auto verdict = verdictOf(surveyDone(), ledgerOf(40.0, 40.0), settings, missed);
        QVERIFY2(QString::fromStdString(verdict.reason).contains(words), verdict.reason.c_str());
        QCOMPARE(verdict.success, missed < 0.1);
    }

    /// Cells of a meter in which every scan hit one half, because crowns hid the other one.
    void tellsOfHolesWithinWhatWasSeen() {
        ScanLedger ledger(area);
        Senses senses = sensesAt({20, 10, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = 0.25; x_m < 40.0; x_m += 1.0)
            for (double y_m = 0.25; y_m < 20.0; y_m += 0.5)
                senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, true, true);
        QCOMPARE(ledger.seen(), 1.0);
        QCOMPARE(ledger.hiddenInSeen(), 0.5);
    }

    void theEdgeOfTheGroundHidesNoHoles() {
        ScanLedger ledger(area);
        Senses senses = sensesAt({20, 10, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = 0.25; x_m < 20.5; x_m += 0.5) // It divides the cells from 20 to 21 m.
            for (double y_m = 0.25; y_m < 20.0; y_m += 0.5)
                senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        QCOMPARE(hiddenAfter(senses, ledger) > 0.02, true);
        for (double y_m = 0.0; y_m < 20.0; y_m += 0.1)
            senses.scan->misses_in_map_m.emplace_back(21.5, y_m, -14.0);
        senses.scan->scanner_in_map.position_m = {21.5, 10.0, 6.0};
        QCOMPARE(hiddenAfter(senses, ledger), 0.0);
    }

    void aVoidIsNoGroundOnTheMap() {
        ScanLedger ledger(area);
        Senses senses = sensesAt({5, 10, 6});
        setFlatScan(senses, {5, 19}, 1.0, 6.0); // The scanner hits what is beside the robot.
        senses.ground_m.reset();
        ledger.note(senses, true, true);
        QCOMPARE(ledger.mapped(), 0.0);
    }

    /// From above a roof, beams end in the air over the street.
    void beamsThatEndAboveTheGroundDoNotLookForIt_data() {
        QTest::addColumn<double>("ground_m");
        QTest::addColumn<bool>("look");
        QTest::newRow("high over the street") << 0.0 << false;
        QTest::newRow("low over the ground beside a ravine") << 14.0 << true;
    }
    void beamsThatEndAboveTheGroundDoNotLookForIt() {
        QFETCH(double, ground_m);
        QFETCH(bool, look);
        ScanLedger ledger(area);
        Senses senses = sensesAt({20, 10, 20});
        senses.ground_m = ground_m;
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        senses.scan->misses_in_map_m = {Vec3(34, 10, 6)};
        ledger.note(senses, true, true);
        QCOMPARE(ledger.bottomless() > 0.0, look);
    }

    void flatBeamsDoNotLookForGround() {
        ScanLedger ledger(area);
        Senses senses = sensesAt({20, 10, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        senses.scan->misses_in_map_m = {Vec3(38, 10, 1)};
        ledger.note(senses, true, true);
        QCOMPARE(ledger.bottomless(), 0.0);
    }
};

USAR_TEST(tst_Verdict)

} // namespace tst_verdict

#include "tst_verdict.moc"
