#include <QTest>

#include "core/mission/session/scan_book.h"
#include "tests/mission/session/session_parts.h"
#include "tests/suite/suite.h"

namespace tst_scan_book {

using namespace usar;
using namespace usar::mission;

namespace {

struct Kept : test::NoticeBook {
    /// A scan comes in this line, and the behavior says that it was taken 5 m above the origin.
    void scan(std::uint64_t line) {
        const protocol::RangeScan scan{
            .name = "Scanner1", .resolution_rad = 0.1, .fov_rad = 0.2, .ranges_m = {2.0, 2.0, 2.0}};
        book.take(protocol::InfoLine{{line}, "SEN", scan, {}});
        place(line);
    }
    void place(std::uint64_t line) {
        book.take(agent::ScanPlacement{.scan_line = {line},
                                       .scanner_in_map = {.position_m = {0.0, 0.0, 5.0}, .pitch_rad = pi / 2}});
    }
    void moveTo(double x_m) { book.take(agent::PoseEstimate{Seconds{1.0}, {.position_m = {x_m, 0.0, 5.0}}}); }

    ScanBook book{0.25, notices};
};

} // namespace

class tst_ScanBook : public QObject {
    Q_OBJECT
private slots:
    void nothingIsWorthSavingWithoutAMap() {
        Kept kept;
        kept.moveTo(1.0);
        kept.book.take(agent::MapMark{});
        QCOMPARE(kept.book.record().revision, std::uint64_t(0));
        QCOMPARE(kept.book.record().marks.size(), std::size_t(1));
        QVERIFY(kept.book.snapshot().raster.empty());
    }

    void theCourseOfATaskIsKept() {
        Kept kept;
        kept.book.beginTask("airrobot/cpp", "R1", Rectangle{{-0.25, -0.25}, {0.25, 0.25}});
        agent::BehaviorStatus status;
        kept.book.take(status);
        kept.scan(1);
        for (const double elapsed_s : {2.0, 5.0}) {
            status.elapsed = Seconds{elapsed_s};
            kept.book.take(status);
        }
        const auto points = kept.book.record().course.points();
        QCOMPARE(points.size(), std::size_t(2));
        QVERIFY((points.front() == CoveragePoint{Seconds{0.0}, 0.0}));
        QCOMPARE(points.back().elapsed.count(), 5.0);
        QVERIFY(points.back().coverage_pct > 0.0);
        kept.book.beginTask("airrobot/cpp", "R1", Rectangle{{-0.25, -0.25}, {0.25, 0.25}});
        QVERIFY(kept.book.record().course.points().empty());
    }

    void whatIsWorthSavingIsCounted() {
        Kept kept;
        kept.scan(1);
        QCOMPARE(kept.book.record().revision, std::uint64_t(1));
        kept.moveTo(1.0);
        kept.book.take(agent::MapMark{});
        agent::BehaviorStatus status;
        status.state = "scanning";
        kept.book.take(status);
        QCOMPARE(kept.book.record().revision, std::uint64_t(4));
        status.elapsed = Seconds{5.0};
        kept.book.take(status);
        QCOMPARE(kept.book.record().revision, std::uint64_t(4)); // time alone is no news
        QCOMPARE(kept.book.record().status.elapsed.count(), 5.0);
        QVERIFY(!kept.book.snapshot().raster.empty());
    }

    void scansAreKeptForExportsIfSomebodyWantsThem_data() {
        QTest::addColumn<bool>("keeps");
        QTest::addColumn<bool>("asked");
        QTest::addColumn<int>("scans"); // -1: there are none to hand out
        QTest::newRow("kept and asked for") << true << true << 2;
        QTest::newRow("not asked for") << true << false << -1;
        QTest::newRow("not kept") << false << true << -1;
    }

    void scansAreKeptForExportsIfSomebodyWantsThem() {
        QFETCH(bool, keeps);
        QFETCH(bool, asked);
        Kept kept;
        kept.book.setAdjust(false);
        kept.book.keepScans(keeps);
        kept.moveTo(0.0);
        kept.scan(1);
        kept.scan(2);
        const ScanRecord record = kept.book.snapshot(asked);
        QTEST(record.scans ? int(record.scans->size()) : -1, "scans");
        if (!record.scans)
            return;
        const mapping::KeptScan& scan = record.scans->front();
        QCOMPARE(scan.time.count(), 1.0);
        QVERIFY(scan.scanner_in_map.position_m == Vec3(0.0, 0.0, 5.0));
        QCOMPARE(scan.ranges_m, (std::vector<float>{2.0f, 2.0f, 2.0f}));
        kept.book.rewind();
        QVERIFY(!kept.book.snapshot(true).scans);
    }

    void scansOfAnEarlierRunComeFirst() {
        Kept before, after;
        for (Kept* kept : {&before, &after}) {
            kept->book.keepScans(true);
            kept->moveTo(0.0);
        }
        before.scan(7);
        EarlierScan earlier{before.book.snapshot(true), {}, {.recording = "r.usarrec"}};
        after.book.continueScan(earlier);
        QCOMPARE(after.book.snapshot(true).scans->size(), std::size_t(1));
        after.scan(1);
        const auto scans = after.book.snapshot(true).scans;
        QVERIFY(scans && scans->size() == 2);
        QCOMPARE(scans->front().line.value, std::uint64_t(7));
        QCOMPARE(scans->back().line.value, std::uint64_t(1));
        after.book.beginReplay({}, "hills");
        QVERIFY(!after.book.snapshot(true).scans);
    }

    void aPathIsOfPointsACellApart() {
        Kept kept;
        for (const double x_m : {0.0, 0.1, 0.2, 0.3, 0.4})
            kept.moveTo(x_m);
        QCOMPARE(kept.book.record().path_m.size(), std::size_t(2));
        QCOMPARE(kept.book.record().path_m.back().x(), 0.3);
    }

    void continuesWhatAnEarlierRunScanned() {
        Kept before;
        before.scan(1);
        before.book.take(agent::MapMark{});
        EarlierScan earlier{before.book.record(), {}, {.recording = "r.usarrec", .charges = 2, .cells = 3}};
        earlier.record.area_in_map = {{-5, -5}, {5, 5}};
        for (const auto& tile : before.book.mapper().map().takeChangedTiles())
            earlier.tiles[tile->index] = tile;
        Kept after;
        after.book.continueScan(earlier);
        after.book.beginTask("test/hop", "R2", {{0, 0}, {5, 5}});
        const ScanRecord kept = after.book.snapshot();
        QCOMPARE(kept.area_in_map, earlier.record.area_in_map); // of the whole, of which the task is a part
        QCOMPARE(kept.robot_name, std::string("R2"));
        QCOMPARE(kept.marks.size(), std::size_t(1));
        QVERIFY(kept.continues && kept.continues->charges == 2);
        QVERIFY(kept.raster.heights_m.size() == before.book.snapshot().raster.heights_m.size());
        QCOMPARE(knownCellCount(kept), knownCellCount(before.book.snapshot()));
        QVERIFY(kept.raster.range() == before.book.snapshot().raster.range());
        after.book.continueScan(earlier); // The map has heights already, so nothing comes twice.
        QCOMPARE(after.book.record().marks.size(), std::size_t(1));
        after.book.beginTask("test/hop", "R2", {{0, 0}, {5, 5}});
        after.book.beginTask("test/hop", "R2", {{1, 1}, {5, 5}});
        QCOMPARE(after.book.record().area_in_map, (Rectangle{{1, 1}, {5, 5}}));
    }

    void aScanThatIsTooOldIsToldOnce() {
        Kept kept;
        kept.place(7);
        kept.place(8);
        QCOMPARE(kept.topics(), std::vector<std::string>{"placement"});
        kept.scan(9);
        kept.book.beginConnection();
        kept.place(9); // line numbers start again
        QCOMPARE(kept.book.record().revision, std::uint64_t(1));
    }

    void cellsChangeOnlyInAnEmptyMap() {
        Kept kept;
        kept.book.setCellSize(0.5);
        QCOMPARE(kept.book.cellSize_m(), 0.5);
        kept.scan(1);
        kept.book.setCellSize(0.5);
        QVERIFY(kept.said.empty());
        kept.book.setCellSize(0.25);
        QCOMPARE(kept.book.cellSize_m(), 0.5);
        QCOMPARE(kept.topics(), std::vector<std::string>{"cell size"});
        QVERIFY(kept.saidWords("keeps its cells of 0.50 m"));
    }

    void aNewTaskKeepsTheMap() {
        Kept kept;
        kept.scan(1);
        agent::BehaviorStatus status;
        status.state = "done";
        kept.book.take(status);
        kept.book.beginTask("airrobot/cpp", "R1", {{0.0, 0.0}, {10.0, 10.0}});
        QCOMPARE(kept.book.record().behavior_id, std::string("airrobot/cpp"));
        QCOMPARE(kept.book.record().robot_name, std::string("R1"));
        QVERIFY(kept.book.record().status == agent::BehaviorStatus{});
        QVERIFY(!kept.book.snapshot().raster.empty());
    }

    void aRewoundReplayKeepsOnlyTheLevel() {
        Kept kept;
        protocol::GameInfo game;
        game.level = "tall_test";
        kept.book.take(protocol::InfoLine{{1}, "NFO", game, {}});
        kept.scan(2);
        kept.moveTo(1.0);
        kept.book.take(agent::MapMark{});
        kept.book.noteFault("wind");
        kept.book.rewind();
        const ScanRecord left = kept.book.snapshot();
        QVERIFY(left.raster.empty() && left.path_m.empty() && left.marks.empty() && left.faults.empty());
        QCOMPARE(left.level, std::string("tall_test"));
        QCOMPARE(left.revision, std::uint64_t(0));
    }

    void aReplayHasTheCellsOfItsRecording() {
        Kept kept;
        kept.book.beginReplay(1.0, "flat");
        QCOMPARE(kept.book.cellSize_m(), 1.0);
        kept.book.beginReplay(std::nullopt, "");
        QCOMPARE(kept.book.cellSize_m(), 1.0);
        QCOMPARE(kept.book.record().level, std::string());
    }
};

USAR_TEST(tst_ScanBook)

} // namespace tst_scan_book

#include "tst_scan_book.moc"
