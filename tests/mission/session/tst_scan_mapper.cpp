#include <QTest>

#include <cmath>

#include "core/mission/session/scan_mapper.h"
#include "tests/suite/suite.h"

namespace tst_scan_mapper {

using namespace usar;
using usar::mission::ScanMapper;

namespace {

/// Three beams 0.1 rad apart about straight ahead.
protocol::RangeScan scanOf(double range_m, const std::string& name = "Scanner1") {
    return {.name = name, .resolution_rad = 0.1, .fov_rad = 0.2, .ranges_m = {range_m, range_m, range_m}};
}

/// A scanner at the height of 5 m that looks straight down.
agent::ScanPlacement downFrom(double x_m, std::uint64_t line) {
    return {.scan_line = {line}, .scanner_in_map = {.position_m = {x_m, 0.0, 5.0}, .pitch_rad = pi / 2}};
}

protocol::ConfigurationInfo maximumRange(const std::string& name, double maximum_m) {
    return {"IRScanner", {{name, {{"MaxRange", std::to_string(maximum_m), maximum_m}, {"Fov", "3.1415", 3.1415}}}}};
}

} // namespace

class tst_ScanMapper : public QObject {
    Q_OBJECT
private slots:
    void writesAScanWhereTheBehaviorSaysItWasTaken() {
        ScanMapper mapper(0.25);
        mapper.takeScan(scanOf(2.0), {41});
        mapper.takeScan(scanOf(3.0), {47});
        QVERIFY(mapper.place(downFrom(10.0, 47)));
        const auto cell = mapper.map().cellAt({10.0, 0.0});
        QVERIFY(mapper.map().height_m(cell));
        QVERIFY(std::abs(*mapper.map().height_m(cell) - 2.0f) < 0.05f);
        QCOMPARE(mapper.map().line(cell), LineNumber{47});
        QCOMPARE(mapper.lastHits().size(), std::size_t(3));
    }

    void forgetsScansThatAreTooOld() {
        ScanMapper mapper(0.25);
        for (std::uint64_t line = 1; line <= ScanMapper::shelf_size + 1; ++line)
            mapper.takeScan(scanOf(2.0), {line});
        QVERIFY(!mapper.place(downFrom(0.0, 1)));
        QVERIFY(mapper.place(downFrom(0.0, 2)));
        QVERIFY(!mapper.place(downFrom(0.0, 1000)));
        QVERIFY(!mapper.place(downFrom(0.0, 0)));
    }

    void joinsOnlyScansThatFollowOneAnother_data() {
        QTest::addColumn<bool>("one_is_skipped");
        QTest::newRow("consecutive scans are joined") << false;
        QTest::newRow("a scan in between was not placed") << true;
    }

    void joinsOnlyScansThatFollowOneAnother() {
        QFETCH(bool, one_is_skipped);
        ScanMapper mapper(0.25);
        mapper.takeScan(scanOf(2.0), {1});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        mapper.takeScan(scanOf(2.0), {2});
        if (one_is_skipped)
            mapper.takeScan(scanOf(2.0), {3});
        QVERIFY(mapper.place(downFrom(1.2, one_is_skipped ? 3 : 2)));
        QCOMPARE(mapper.map().height_m(mapper.map().cellAt({0.6, 0.0})).has_value(), !one_is_skipped);
    }

    void joinsTheScansOfEachScannerApart() {
        ScanMapper mapper(0.25);
        mapper.takeScan(scanOf(2.0, "Belly"), {1});
        mapper.takeScan(scanOf(2.0, "Front"), {2});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        QVERIFY(mapper.place(downFrom(-1.2, 2)));
        mapper.takeScan(scanOf(2.0, "Belly"), {3});
        mapper.takeScan(scanOf(2.0, "Front"), {4}); // never placed, which breaks nothing for the other
        QVERIFY(mapper.place(downFrom(1.2, 3)));
        const auto known = [&](double x_m) {
            return mapper.map().height_m(mapper.map().cellAt({x_m, 0.0})).has_value();
        };
        QVERIFY(known(0.6));
        QVERIFY(!known(-0.6));
    }

    void thereIsAnEndOfScanners() {
        ScanMapper mapper(0.25);
        for (std::uint64_t line = 1; line <= 1000; ++line)
            mapper.takeScan(scanOf(2.0, "garbled" + std::to_string(line)), {line});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        QVERIFY(mapper.place(downFrom(0.0, 1000)));
        QVERIFY(!mapper.place(downFrom(0.0, 500)));
    }

    void takesTheMaximumRangeFromTheConfiguration() {
        ScanMapper mapper(0.25);
        mapper.takeConfiguration(maximumRange("Scanner1", 4.0));
        mapper.takeConfiguration(maximumRange("Scanner2", -1.0)); // nonsense is not believed
        mapper.takeScan(scanOf(4.5), {1});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        QCOMPARE(mapper.map().knownCellCount(), std::size_t(0));
        mapper.takeScan(scanOf(4.5, "Scanner2"), {2});
        QVERIFY(mapper.place(downFrom(0.0, 2)));
        QVERIFY(mapper.map().knownCellCount() > 0);
    }

    void survivesANanRange() {
        ScanMapper mapper(0.25);
        protocol::RangeScan scan = scanOf(2.0);
        scan.ranges_m[1] = std::nan("");
        mapper.takeScan(scan, {1});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        const auto range = mapper.map().range();
        QVERIFY(range && std::isfinite(range->minimum_m) && std::isfinite(range->maximum_m));
        QVERIFY(mapper.lastHits()[1].hasNaN());
        QVERIFY(!mapper.lastHits()[0].hasNaN());
    }

    void aNewConnectionKeepsTheMapAndForgetsTheScans() {
        ScanMapper mapper(0.25);
        mapper.takeScan(scanOf(2.0), {1});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        const std::size_t known = mapper.map().knownCellCount();
        mapper.forgetScans();
        QVERIFY(!mapper.place(downFrom(0.0, 1)));
        QCOMPARE(mapper.map().knownCellCount(), known);
    }

    void clearingEmptiesTheMap() {
        ScanMapper mapper(0.5);
        mapper.takeScan(scanOf(2.0), {1});
        QVERIFY(mapper.place(downFrom(0.0, 1)));
        mapper.clearMap();
        QCOMPARE(mapper.map().knownCellCount(), std::size_t(0));
        QCOMPARE(mapper.map().cellSize_m(), 0.5);
    }

    void placesAScanWithoutTheDriftOfTheRoll_data() {
        QTest::addColumn<bool>("mount_known");
        QTest::addColumn<bool>("wanted");
        QTest::addColumn<double>("hit_y_m");
        QTest::newRow("as the dynamics say") << true << true << 0.0;
        QTest::newRow("as the INS says, if nobody wants it") << true << false << 0.5;
        QTest::newRow("as the INS says, if the mount is unknown") << false << true << 0.5;
    }
    void placesAScanWithoutTheDriftOfTheRoll() {
        QFETCH(bool, mount_known);
        QFETCH(bool, wanted);
        QFETCH(double, hit_y_m);
        const Pose mount{.pitch_rad = pi / 2};
        ScanMapper mapper(0.25);
        mapper.improve(wanted);
        if (mount_known)
            mapper.takeGeometry({"RangeScanner", {{"Scanner1", mount, "HARD"}}});
        Pose base{.position_m = {0.0, 0.0, 5.0}};
        for (int tick = 1; tick <= 300; ++tick) { // A roll of 0.1 rad creeps in while the robot flies straight ahead.
            base.position_m.x() = 0.2 * tick;
            base.roll_rad = std::min(0.1, 0.0005 * tick) + (tick % 2 ? 0.02 : -0.02);
            mapper.takePose({Seconds(0.2 * tick), base});
        }
        base.roll_rad = 0.1;
        mapper.takeScan(scanOf(5.0), {41});
        QVERIFY(mapper.place({{41}, base * mount}));
        QVERIFY(std::abs(mapper.lastHits().at(1).y() - hit_y_m) < 0.1);
    }
};

USAR_TEST(tst_ScanMapper)

} // namespace tst_scan_mapper

#include "tst_scan_mapper.moc"
