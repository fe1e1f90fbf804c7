#include <QJsonArray>
#include <QTest>

#include "core/mission/runs/run_summary.h"
#include "tests/mission/files/sample_scan.h"
#include "tests/suite/suite.h"

namespace tst_run_summary {

using namespace usar;
using namespace usar::mission;

class tst_RunSummary : public QObject {
    Q_OBJECT
private slots:
    void damageIsNoSuccess() {
        RunSummary summary;
        summary.success = true;
        summary.reason = "Done.";
        judgeDamage(summary); // Nothing is known.
        QVERIFY(summary.success);
        summary.truth = TrueFigures{.collisions = 2};
        judgeDamage(summary);
        QVERIFY(summary.success);
        summary.truth->broken = true;
        judgeDamage(summary);
        QVERIFY(!summary.success);
        QCOMPARE(summary.reason, "Done. But the robot is broken.");
    }

    void allKeysArePresentAndWhatNobodyKnowsIsNull() {
        const QJsonObject refused = toJson(RunSummary{});
        RunSummary flown;
        flown.truth = TrueFigures{3, 12.5, Seconds(4.0), 1, 2, Seconds(7.5), HeightOverGround{0.5, 4.0, 0.25}};
        flown.seed = 7;
        QCOMPARE(toJson(flown).keys(), refused.keys());
        QCOMPARE(refused.size(), 36);
        for (const char* key : {"mission", "behavior", "plan", "seed", "speed_x", "rmse_m", "rmse_surface_m",
                                "collisions", "true_distance_m", "least_height_m", "first_touch_s",
                                "contacts_after_stop", "reachable_coverage_pct", "unreachable_m2"})
            QVERIFY2(refused[key].isNull(), key);
        QCOMPARE(toJson(flown)["seed"].toInt(), 7);
    }

    void tellsWhatTheAdjustmentHasDone_data() {
        QTest::addColumn<int>("verdict");
        QTest::addColumn<QString>("word");
        QTest::newRow("declined") << int(mapping::AdjustmentVerdict::Declined) << "declined";
        QTest::newRow("bridged") << int(mapping::AdjustmentVerdict::Bridged) << "bridged";
        QTest::newRow("adjusted") << int(mapping::AdjustmentVerdict::Adjusted) << "adjusted";
    }
    void tellsWhatTheAdjustmentHasDone() {
        QFETCH(int, verdict);
        QFETCH(QString, word);
        ScanRecord record = sampleScan(20);
        record.adjustment = MapAdjustment{.verdict = mapping::AdjustmentVerdict(verdict),
                                          .reason = "Because.",
                                          .residual_before_m = 0.43219,
                                          .overlaps = 7,
                                          .shift = PathShift{0.4321, 1.2345}};
        RunSummary summary;
        QVERIFY(toJson(summary)["adjustment"].isNull());
        addRecord(summary, record, nullptr);
        const QJsonObject told = toJson(summary)["adjustment"].toObject();
        QCOMPARE(told["verdict"].toString(), word);
        QCOMPARE(told["reason"].toString(), QString("Because."));
        QCOMPARE(told["residual_before_m"].toDouble(), 0.4322);
        QVERIFY(told["residual_after_m"].isNull());
        QCOMPARE(told["overlaps"].toInt(), 7);
        QCOMPARE(told["mean_shift_m"].toDouble(), 0.432);
        QCOMPARE(told["greatest_shift_m"].toDouble(), 1.235);
        summary.adjustment->shift.reset();
        const QJsonObject unmoved = toJson(summary)["adjustment"].toObject();
        QVERIFY(unmoved["mean_shift_m"].isNull() && unmoved["greatest_shift_m"].isNull());
    }

    void theCourseIsToldOnlyToThoseWhoAsk() {
        ScanRecord record = sampleScan(20);
        record.course.add({Seconds(5.0), 1.234});
        record.status.elapsed = Seconds(7.0);
        record.marks = {{agent::MarkKind::GoalGivenUp, {1.5, -2.0, 3.0}, Seconds{1.0}, {}},
                        {agent::MarkKind::Landing, {9.0, 9.0, 9.0}, Seconds{2.0}, {}}};
        record.path_m.clear();
        for (int i = 0; i < 1000; ++i)
            record.path_m.emplace_back(i, 0.0, 2.0);
        RunSummary summary;
        summary.truth = TrueFigures{.collisions = 1};
        summary.truth->collision_places_in_map_m = {{4.0, 5.0, 6.0}};
        QVERIFY(!toJson(summary).contains("course"));
        summary.course = courseOf(record, 2.5, 100);
        const QJsonObject course = toJson(summary)["course"].toObject();
        QCOMPARE(course["coverage"].toArray(), (QJsonArray{QJsonArray{5.0, 1.23}, QJsonArray{7.0, 2.5}}));
        QCOMPARE(course["given_up"].toArray(), (QJsonArray{QJsonArray{1.5, -2.0}}));
        QCOMPARE(course["collisions"].toArray(), (QJsonArray{QJsonArray{4.0, 5.0}}));
        QVERIFY(course["path"].toArray().size() <= 100 && course["path"].toArray().size() > 50);
        QCOMPARE(course["path"].toArray().first().toArray(), (QJsonArray{0.0, 0.0}));
        QCOMPARE(course["path"].toArray().last().toArray(), (QJsonArray{999.0, 0.0}));
    }

    void figuresAreRounded_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("value");
        QTest::newRow("protocol time") << "duration_s" << 12.35;
        QTest::newRow("wall time") << "wall_s" << 3.457;
        QTest::newRow("speed") << "speed_x" << 3.6;
        QTest::newRow("distance") << "distance_m" << 100.12;
        QTest::newRow("coverage") << "coverage_pct" << 66.67;
        QTest::newRow("error of heights") << "rmse_m" << 0.1235;
        QTest::newRow("true distance") << "true_distance_m" << 9.88;
    }

    void figuresAreRounded() {
        QFETCH(QString, key);
        QFETCH(double, value);
        RunSummary summary;
        summary.duration = Seconds(12.3456);
        summary.wall = Seconds(3.4567);
        summary.distance_m = 100.1234;
        summary.score = {.coverage_pct = 66.6666, .rmse_m = 0.123456, .rmse_surface_m = std::nullopt};
        summary.truth = TrueFigures{.distance_m = 9.8765};
        QCOMPARE(toJson(summary)[key].toDouble(), value);
    }

    void smallHolesAreToldButDoNotCountAsCovered() {
        ScanRecord record = sampleScan(20);
        RunSummary before;
        addRecord(before, record, nullptr);
        QCOMPARE(before.filled_m2, 0.0);
        record.raster.heights_m[std::size_t(5 * record.raster.columns + 9)] = std::nanf("");
        RunSummary after;
        addRecord(after, record, nullptr);
        QCOMPARE(toJson(after)["filled_m2"].toDouble(), 0.06);
        QVERIFY(after.score.coverage_pct < before.score.coverage_pct);
    }

    void takesWhatTheRecordSays() {
        ScanRecord record = sampleScan(20);
        record.status.distance_flown_m = 12.0;
        record.status.charges = 2;
        record.faults = {"60.2 s: fault begins: wind speed=5"};
        RunSummary summary;
        addRecord(summary, record, nullptr);
        QCOMPARE(summary.distance_m, 12.0);
        QCOMPARE(summary.charges, 2);
        QCOMPARE(summary.cells, record.raster.knownCellCount());
        QCOMPARE(summary.score.coverage_pct, score(record.raster, record.area_in_map, nullptr).coverage_pct);
        QVERIFY(!summary.score.rmse_m);
        QCOMPARE(summary.faults, QStringList{"60.2 s: fault begins: wind speed=5"});
        const Truth truth{[](const Vec2&) { return 0.0; }, [](const Vec2&) { return 0.0; }};
        addRecord(summary, record, &truth);
        QVERIFY(summary.score.rmse_m);
        QVERIFY(!summary.reach && summary.warnings.empty());
    }

    void tellsWhatCouldBeReached() {
        const ScanRecord record = sampleScan(20);
        const Rectangle& area = record.area_in_map;
        const Truth truth{
            .surface_m = [](const Vec2&) { return 0.0; },
            .ground_m = [](const Vec2&) { return 0.0; },
            .world_in_map = {area.min_m, area.center_m()},
            .reach = [](const FlightLimits&, const Rectangle&) { return [](const Vec2&) { return Reach::Scanned; }; }};
        RunSummary flown;
        addRecord(flown, record, &truth, FlightLimits{});
        QVERIFY(flown.reach);
        QCOMPARE(toJson(flown)["unreachable_m2"].toDouble(), std::round(7.5 * area.area_m2()) / 10.0);
        QVERIFY(toJson(flown)["reachable_coverage_pct"].isDouble());
        QVERIFY(toJson(flown)["warnings"][0].toString().startsWith("75 % of the mission area"));
        RunSummary driven; // by a robot that does not fly
        addRecord(driven, record, &truth, std::nullopt);
        QVERIFY(toJson(driven)["reachable_coverage_pct"].isNull() && toJson(driven)["unreachable_m2"].isNull());
        QVERIFY(toJson(driven)["warnings"][0].toString().contains("is outside the world"));
        QVERIFY(toJson(RunSummary{})["warnings"].toArray().empty());
    }

    void takesWhatTheSessionSays() {
        SessionFigures figures;
        figures.lines_received = 70;
        figures.lines_malformed = 3;
        figures.lockstep = true;
        RunSummary summary;
        addSession(summary, figures);
        const QJsonObject json = toJson(summary);
        QCOMPARE(json["lines_received"].toInt(), 70);
        QCOMPARE(json["lines_malformed"].toInt(), 3);
        QVERIFY(json["lockstep"].toBool());
    }
};

USAR_TEST(tst_RunSummary)

} // namespace tst_run_summary

#include "tst_run_summary.moc"
