#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "core/mapping/scan_points.h"
#include "core/mission/session/scan_book.h"
#include "tests/suite/suite.h"

namespace tst_map_adjuster {

using namespace usar;
using mapping::AdjustmentVerdict;
using mission::ScanBook;

namespace {

double hills(double x_m, double y_m) {
    return std::sin(0.7 * x_m) + std::sin(0.6 * y_m + 0.3);
}

/// A session's book and a robot that flies over hills, with a scanner that looks straight down.
class Flight {
public:
    explicit Flight(bool adjust = true) {
        book.setAdjust(adjust);
        book.beginTask("b", "R1", {{0.0, 0.0}, {30.0, 20.0}});
    }

    void scan(const Vec3& at_m, const Vec3& error_m) {
        const Pose down{.position_m = at_m + error_m, .pitch_rad = pi / 2};
        protocol::RangeScan scan{.name = "Scanner1", .resolution_rad = radians(2.0), .fov_rad = radians(120.0)};
        for (int k = 0; k <= 60; ++k) {
            const double angle_rad = radians(2.0 * k - 60.0);
            double near_m = 0.0, far_m = 20.0;
            for (int i = 0; i < 16; ++i) {
                const double range_m = (near_m + far_m) / 2.0;
                const bool above = at_m.z() - range_m * std::cos(angle_rad) >
                                   hills(at_m.x(), at_m.y() + range_m * std::sin(angle_rad));
                (above ? near_m : far_m) = range_m;
            }
            scan.ranges_m.push_back(near_m);
        }
        if (tells_truth_)
            tellTruth(at_m);
        estimate(at_m + error_m);
        book.take(protocol::InfoLine{{++line_}, "SEN", scan, {}});
        book.take(agent::Published(agent::ScanPlacement{{line_}, down}));
    }
    /// A lane along x at this y, with an error of the estimate.
    void lane(double y_m, const Vec3& error_m) {
        for (double x_m = 0.0; x_m < 30.0; x_m += 0.2)
            scan({x_m, y_m, 6.0}, error_m);
    }
    /// The INS is set where it stands, and the robot waits for a line or so.
    void setIns(const Vec3& at_m, const Vec3& error_m) {
        estimate(at_m + error_m);
        book.takeSent(protocol::SetInsPose{.base_in_map = {.position_m = at_m}});
        estimate(at_m);
    }
    /// The server tells where the robot is.
    void tellTruth(const Vec3& at_m) {
        book.take(
            protocol::InfoLine{{++line_},
                               "SEN",
                               protocol::GroundTruthReading{.name = "GroundTruth", .base_in_map = {.position_m = at_m}},
                               {}});
    }
    void tellsTruth(bool on) { tells_truth_ = on; }
    /// Scans so large that the store has no room for them, which hit nothing.
    void overfill() { fill(std::size_t(-1)); }
    /// Until the store has no room or takes so much.
    void fill(std::size_t bytes) {
        const Pose down{.position_m = {0.0, 0.0, 6.0}, .pitch_rad = pi / 2};
        protocol::RangeScan scan{.name = "Scanner1", .resolution_rad = 1e-6, .fov_rad = 2.0};
        scan.ranges_m.assign(std::size_t(1) << 21, 20.0);
        while (!book.mapper().store().overfull() && book.mapper().store().memoryBytes() < bytes) {
            estimate(down.position_m);
            book.take(protocol::InfoLine{{++line_}, "SEN", scan, {}});
            book.take(agent::Published(agent::ScanPlacement{{line_}, down}));
        }
    }
    void wait(int lines) {
        for (int i = 0; i < lines; ++i)
            book.take(protocol::InfoLine{{++line_}, "NFO", protocol::GameInfo{.level = "hills"}, {}});
    }
    double error_m() {
        const mapping::HeightMap& map = book.mapper().map();
        double sum_m2 = 0.0, cells = 0.0;
        for (double x_m = 1.0; x_m < 29.0; x_m += 0.25)
            for (double y_m = 1.0; y_m < 17.0; y_m += 0.25)
                if (const auto height_m = map.height_m(map.cellAt({x_m + 0.1, y_m + 0.1}))) {
                    const Vec2 center_m = map.center_m(map.cellAt({x_m + 0.1, y_m + 0.1}));
                    sum_m2 += std::pow(double(*height_m) - hills(center_m.x(), center_m.y()), 2);
                    cells += 1.0;
                }
        return std::sqrt(sum_m2 / cells);
    }

    int adjustments = 0; ///< so many were told
    mission::Notices notices{[this](const mission::Notice& notice) {
        adjustments += notice.topic == mission::textOf(mission::Topic::Adjustment) ? 1 : 0;
    }};
    ScanBook book{0.25, notices};

private:
    void estimate(const Vec3& at_m) {
        now_ += Seconds(0.2);
        book.take(agent::Published(agent::PoseEstimate{now_, {.position_m = at_m}}));
    }
    std::uint64_t line_ = 0;
    Seconds now_{0.0};
    bool tells_truth_ = false;
};

/// How far the points of the exported scans are above or below the hills, root mean square.
double pointError_m(Flight& flight) {
    double sum_m2 = 0.0, count = 0.0;
    mapping::eachPoint(*flight.book.snapshot(true).scans, [&](const mapping::ScanPoint& point) {
        sum_m2 += std::pow(point.at_m.z() - hills(point.at_m.x(), point.at_m.y()), 2);
        return ++count > 0.0;
    });
    return std::sqrt(sum_m2 / count);
}

/// Three lanes of which the middle one is misplaced, more than a random walk is likely to do.
void flyThreeLanes(Flight& flight) {
    flight.setIns({0.0, 0.0, 6.0}, Vec3::Zero());
    flight.lane(3.0, Vec3::Zero());
    flight.lane(9.0, {0.3, -0.2, 0.25});
    flight.lane(15.0, {0.1, 0.1, 0.1});
}

} // namespace

class tst_MapAdjuster : public QObject {
    Q_OBJECT
private slots:
    void adjustsTheMapWhenTheInsIsSet() {
        Flight flight;
        flyThreeLanes(flight);
        const double before_m = flight.error_m();
        const auto revision = flight.book.record().revision;
        flight.setIns({0.0, 15.0, 6.0}, {0.1, 0.1, 0.1});
        QVERIFY(!flight.book.record().adjustment);
        flight.wait(30);
        QVERIFY(flight.book.record().adjustment);
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
        QVERIFY2(flight.error_m() < 0.7 * before_m,
                 qPrintable(QString("%1 m, was %2 m").arg(flight.error_m()).arg(before_m)));
        QVERIFY(flight.book.record().revision > revision);
        QVERIFY(!flight.book.adjustPart());
    }

    void aLandingWithEnoughNewScansAdjustsTheMap_data() {
        QTest::addColumn<bool>("watched");
        QTest::addColumn<double>("from_x_m"); // The part of a lane of 30 m that is new; three lanes are not.
        QTest::addColumn<int>("adjustments");
        QTest::newRow("nobody watches, and a quarter is new") << false << 0.0 << 1;
        QTest::newRow("nobody watches, and more than half is new") << false << -70.0 << 2;
        QTest::newRow("somebody watches, and a quarter is new") << true << 0.0 << 2;
        QTest::newRow("somebody watches, and hardly anything is new") << true << 26.0 << 1;
    }
    void aLandingWithEnoughNewScansAdjustsTheMap() {
        QFETCH(bool, watched);
        QFETCH(double, from_x_m);
        QFETCH(int, adjustments);
        Flight flight;
        flight.book.adjustAtEachLanding(watched);
        flyThreeLanes(flight);
        flight.setIns({30.0, 15.0, 6.0}, {0.1, 0.1, 0.1});
        flight.wait(30);
        QCOMPARE(flight.adjustments, 1);
        for (double x_m = from_x_m; x_m < 30.0; x_m += 0.2)
            flight.scan({x_m, 12.0, 6.0}, Vec3::Zero());
        flight.setIns({30.0, 12.0, 6.0}, Vec3::Zero());
        flight.wait(30);
        QCOMPARE(flight.adjustments, adjustments);
    }

    /// As in a replay that jumps: the newest landing has the same adjustment as if all before it had been adjusted.
    void onTheWayToAnotherMomentOnlyTheNewestLandingIsAdjusted() {
        Flight played, passed;
        for (Flight* const flight : {&played, &passed}) {
            flight->book.adjustAtEachLanding(true);
            flight->book.passOn(flight == &passed);
            flyThreeLanes(*flight);
            for (const double y_m : {12.0, 6.0}) {
                flight->setIns({0.0, y_m, 6.0}, {0.1, 0.1, 0.1});
                flight->wait(30);
                flight->lane(y_m, {0.1, 0.0, 0.1});
            }
        }
        QVERIFY(played.adjustments == 2 && passed.adjustments == 0);
        QVERIFY2(!passed.book.adjustPart() && !passed.book.record().adjustment, "work on the way");
        passed.book.passOn(false);
        passed.wait(30);
        QCOMPARE(passed.adjustments, 1);
        const auto &is = *passed.book.record().adjustment, &wanted = *played.book.record().adjustment;
        QCOMPARE(is.verdict, AdjustmentVerdict::Adjusted);
        QCOMPARE(is.reason, wanted.reason);
        QCOMPARE(is.overlaps, wanted.overlaps);
        QCOMPARE(is.residual_after_m, wanted.residual_after_m);
        QVERIFY(passed.book.mapper().map().height_m(passed.book.mapper().map().cellAt({10.0, 6.0})));
    }

    /// Those of a flight of 14 hours are dropped, and its map then stays as it was at the last landing before.
    void landingsOnTheWayAreAdjustedBeforeTheScansNoLongerFit() {
        Flight flight;
        flight.book.passOn(true);
        flyThreeLanes(flight);
        flight.fill(mapping::ScanStore::most_bytes / 2);
        flight.setIns({0.0, 15.0, 6.0}, {0.1, 0.1, 0.1});
        flight.wait(30);
        flight.overfill();
        flight.book.passOn(false);
        flight.book.finishAdjustment();
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
    }

    void theEndOfATaskOnTheWayCountsLikeALanding() {
        Flight flight;
        flight.book.passOn(true);
        flyThreeLanes(flight);
        flight.book.endTask();
        flight.wait(30);
        QVERIFY(!flight.book.record().adjustment);
        flight.book.passOn(false);
        QVERIFY(flight.book.adjustPart());
        flight.wait(30);
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
    }

    void afterAWayWithoutALandingTheWorkGoesOn() {
        Flight flight;
        flyThreeLanes(flight);
        flight.book.endTask();
        flight.wait(3);
        flight.book.passOn(true);
        flight.wait(30);
        QVERIFY(!flight.book.record().adjustment);
        flight.book.passOn(false);
        flight.wait(30);
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
    }

    void theExportedScansAreWhereTheMapHasThem() {
        Flight flight;
        flyThreeLanes(flight);
        const double before_m = pointError_m(flight);
        flight.setIns({0.0, 15.0, 6.0}, {0.1, 0.1, 0.1});
        flight.book.finishAdjustment();
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
        const double after_m = pointError_m(flight);
        QVERIFY2(after_m < 0.7 * before_m, qPrintable(QString("%1 m, was %2 m").arg(after_m).arg(before_m)));
    }

    void adjustsTheMapAtTheEndOfTheTask_data() {
        QTest::addColumn<bool>("with_lines");
        QTest::newRow("a part for each line") << true;
        QTest::newRow("all at once") << false;
    }
    void adjustsTheMapAtTheEndOfTheTask() {
        QFETCH(bool, with_lines);
        Flight flight, other;
        flyThreeLanes(flight);
        flyThreeLanes(other);
        flight.book.endTask();
        if (with_lines)
            flight.wait(30);
        else
            flight.book.finishAdjustment();
        other.book.finishAdjustment();
        const mission::ScanRecord a = flight.book.snapshot(), b = other.book.snapshot();
        QCOMPARE(a.adjustment->verdict, AdjustmentVerdict::Adjusted);
        QVERIFY(std::memcmp(a.raster.heights_m.data(), b.raster.heights_m.data(), a.raster.heights_m.size() * 4) == 0);
        QVERIFY(a.adjustment->path.size() > 200);
        QCOMPARE(a.adjustment->corrected_m->size(), a.adjustment->path.size());
        QCOMPARE(a.adjustment->corrected_m->back(), Vec2(a.adjustment->path.back().corrected_m.head<2>()));
        QCOMPARE(a.adjustment->path.front().time, Seconds(0.0));
        QCOMPARE(a.adjustment->deviation.heights_m.size(), a.raster.heights_m.size());
    }

    void waitsAtALandingUntilHalfOfAllScansAreNew() {
        Flight flight;
        flyThreeLanes(flight);
        flight.setIns({0.0, 15.0, 6.0}, {0.1, 0.1, 0.1});
        flight.wait(30);
        const std::size_t overlaps = flight.book.record().adjustment->overlaps;
        flight.lane(12.0, Vec3::Zero());
        flight.setIns({0.0, 15.0, 6.0}, Vec3::Zero());
        QVERIFY(!flight.book.adjustPart());
        flight.lane(6.0, Vec3::Zero());
        flight.lane(0.0, Vec3::Zero());
        flight.setIns({0.0, 15.0, 6.0}, Vec3::Zero());
        flight.wait(30);
        QVERIFY(flight.book.record().adjustment->overlaps > overlaps);
    }

    void correctsNothingIfTheRobotFliesByTheTruth_data() {
        QTest::addColumn<double>("error_m");
        QTest::addColumn<AdjustmentVerdict>("verdict");
        QTest::newRow("by the truth") << 0.0 << AdjustmentVerdict::Declined;
        QTest::newRow("by its INS") << 1.0 << AdjustmentVerdict::Adjusted;
    }
    void correctsNothingIfTheRobotFliesByTheTruth() {
        QFETCH(double, error_m);
        QFETCH(AdjustmentVerdict, verdict);
        Flight flight;
        flight.tellsTruth(true);
        flight.lane(3.0, Vec3::Zero());
        flight.lane(9.0, error_m * Vec3(0.3, -0.2, 0.25));
        flight.lane(15.0, error_m * Vec3(0.1, 0.1, 0.1));
        flight.book.finishAdjustment();
        QVERIFY2(flight.book.record().adjustment->verdict == verdict, flight.book.record().adjustment->reason.c_str());
        const bool corrected = verdict != AdjustmentVerdict::Declined;
        QCOMPARE(flight.book.correctedPath_m() != nullptr, corrected);
        QCOMPARE(flight.book.record().adjustment->shift.has_value(), corrected);
    }

    void tellsTheCorrectedPathOnceForEachAdjustment() {
        Flight flight;
        flyThreeLanes(flight);
        flight.setIns({0.0, 15.0, 6.0}, {0.1, 0.1, 0.1});
        QVERIFY(!flight.book.correctedPath_m());
        flight.wait(30);
        const auto path_m = flight.book.correctedPath_m();
        QVERIFY(path_m && path_m->size() > 200);
        double error_m = 0.0, points = 0.0;
        for (const Vec2& point_m : *path_m)
            if (std::abs(point_m.y() - 9.0) < 1.0) { // The lane that the robot believed to fly 0.2 m beside.
                error_m += std::abs(point_m.y() - 9.0);
                points += 1.0;
            }
        QVERIFY2(error_m / points < 0.1, qPrintable(QString("%1 m").arg(error_m / points)));
        const auto& shift = flight.book.record().adjustment->shift;
        QVERIFY(shift && shift->mean_m > 0.1 && shift->greatest_m > shift->mean_m && shift->greatest_m < 0.8);
        flight.lane(12.0, Vec3::Zero());
        QVERIFY2(flight.book.correctedPath_m() == path_m, "no copy with new lines");
        flight.book.finishAdjustment();
        QVERIFY(flight.book.correctedPath_m() != path_m);
        QVERIFY(flight.book.correctedPath_m()->size() > path_m->size());
    }

    void dropsTheCorrectedPathWithTheMap_data() {
        QTest::addColumn<std::function<void(ScanBook&)>>("empty");
        QTest::newRow("rewound") << std::function([](ScanBook& book) { book.rewind(); });
        QTest::newRow("a replay begins") << std::function([](ScanBook& book) { book.beginReplay(0.5, "hills"); });
    }
    void dropsTheCorrectedPathWithTheMap() {
        QFETCH(std::function<void(ScanBook&)>, empty);
        Flight flight;
        flyThreeLanes(flight);
        flight.book.finishAdjustment();
        QVERIFY(flight.book.correctedPath_m());
        empty(flight.book);
        QVERIFY(!flight.book.correctedPath_m());
        flight.wait(5);
        QVERIFY(!flight.book.correctedPath_m());
    }

    void staysCorrectedWhenTheScansNoLongerFit() {
        Flight flight;
        flyThreeLanes(flight);
        flight.book.finishAdjustment();
        const double error_m = flight.error_m();
        const std::string reason = flight.book.record().adjustment->reason;
        const auto path_m = flight.book.correctedPath_m();
        flight.overfill();
        for (int i = 0; i < 2; ++i) {
            flight.book.finishAdjustment();
            const auto& adjustment = *flight.book.record().adjustment;
            QCOMPARE(adjustment.verdict, AdjustmentVerdict::Adjusted);
            QCOMPARE(adjustment.reason, reason + " The rest is as it was flown. The flight was too long for all its "
                                                 "scans to be kept.");
            QVERIFY(path_m && flight.book.correctedPath_m() == path_m);
            QVERIFY(adjustment.shift);
        }
        QCOMPARE(flight.error_m(), error_m);
    }

    void placesScansBetterInFlight() {
        Flight followed, plain;
        followed.book.adjustInFlight(true);
        const Vec3 drift_m(0.3, -0.2, 0.25);
        for (Flight* const flight : {&plain, &followed}) {
            flight->setIns({0.0, 0.0, 6.0}, Vec3::Zero());
            for (const double y_m : {3.0, 6.0})
                flight->lane(y_m, Vec3::Zero());
            for (const double y_m : {9.0, 12.0, 15.0})
                flight->lane(y_m, drift_m);
        }
        QVERIFY2(followed.error_m() < 0.8 * plain.error_m(),
                 qPrintable(QString("%1 m, and %2 m without").arg(followed.error_m()).arg(plain.error_m())));
        QVERIFY(pointError_m(followed) < 0.8 * pointError_m(plain));
        for (Flight* const flight : {&plain, &followed}) {
            flight->book.endTask();
            flight->wait(50);
        }
        QCOMPARE(followed.error_m(), plain.error_m()); // All scans are adjusted from what the robot believed.
    }

    void forgetsWhatItFoundInFlightWhenTheInsIsSet() {
        Flight flight;
        flight.book.adjustInFlight(true);
        const Vec3 drift_m(0.3, -0.2, 0.25);
        flight.setIns({0.0, 0.0, 6.0}, Vec3::Zero());
        for (const double y_m : {3.0, 6.0})
            flight.lane(y_m, Vec3::Zero());
        for (const double y_m : {9.0, 12.0})
            flight.lane(y_m, drift_m);
        const auto middleHit = [&] { return flight.book.mapper().lastHits().at(30); };
        const double moved_m = (middleHit().head<2>() - Vec2(29.8, 12.0) - drift_m.head<2>()).norm();
        QVERIFY2(moved_m > 0.1, qPrintable(QString::number(moved_m)));
        flight.setIns({29.8, 12.0, 6.0}, drift_m);
        flight.scan({15.0, 12.0, 6.0}, Vec3::Zero());
        QVERIFY(std::abs(middleHit().x() - 15.0) < 1e-3);
    }

    void keepsTheThesissMapIfNobodyWantsAnother() {
        Flight flight(false);
        flyThreeLanes(flight);
        const double before_m = flight.error_m();
        flight.book.finishAdjustment();
        QVERIFY(!flight.book.record().adjustment);
        QCOMPARE(flight.error_m(), before_m);
        QCOMPARE(flight.book.mapper().store().memoryBytes(), std::size_t(0));
    }

    void takesScansInThatComeMeanwhile() {
        Flight flight;
        flyThreeLanes(flight);
        flight.book.endTask();
        flight.wait(3);
        flight.lane(60.0, Vec3::Zero());
        flight.wait(30);
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
        QVERIFY(flight.book.mapper().map().height_m(flight.book.mapper().map().cellAt({10.0, 60.0})));
    }

    void clearsTilesOfWhichNothingIsLeft() {
        Flight flight;
        flyThreeLanes(flight);
        const auto tiles = flight.book.mapper().map().tileIndices();
        flight.book.mapper().map().takeChangedTiles();
        flight.book.finishAdjustment();
        const auto changed = flight.book.mapper().map().takeChangedTiles();
        for (const mapping::GridIndex& index : tiles)
            QVERIFY(std::ranges::any_of(changed, [&](const auto& tile) { return tile->index == index; }));
    }

    void keepsWhatAnEarlierRunHasScanned() {
        Flight earlier(false), flight;
        earlier.lane(60.0, Vec3::Zero());
        mission::EarlierScan scan{.record = earlier.book.record(), .tiles = {}, .run = {}};
        for (const auto& tile : earlier.book.mapper().map().takeChangedTiles())
            scan.tiles[tile->index] = tile;
        flight.book.continueScan(scan);
        flyThreeLanes(flight);
        flight.book.finishAdjustment();
        QCOMPARE(flight.book.record().adjustment->verdict, AdjustmentVerdict::Adjusted);
        QVERIFY(flight.book.mapper().map().height_m(flight.book.mapper().map().cellAt({10.0, 60.0})));
    }

    void forgetsEverythingWithTheMap() {
        Flight flight;
        flyThreeLanes(flight);
        flight.book.endTask();
        flight.wait(1);
        flight.book.rewind();
        QVERIFY(!flight.book.adjustPart());
        QVERIFY(flight.book.mapper().store().scans().empty());
        flight.book.finishAdjustment();
        QCOMPARE(flight.book.mapper().map().knownCellCount(), std::size_t(0));
    }

    void believesThatTheInsWasSetOnlyIfTheEstimateShowsIt_data() {
        QTest::addColumn<double>("to_x_m");
        QTest::addColumn<bool>("confirmed");
        QTest::addColumn<int>("sorties");
        QTest::newRow("far from it") << 500.0 << false << 1;
        QTest::newRow("far from it, whatever the server says") << 500.0 << true << 1;
        QTest::newRow("as far as an INS may err at rest") << 0.2 << false << 1;
        QTest::newRow("as far as an INS may err at rest, and the server has set it") << 0.2 << true << 2;
        QTest::newRow("there") << 0.01 << false << 2;
    }
    void believesThatTheInsWasSetOnlyIfTheEstimateShowsIt() {
        QFETCH(double, to_x_m);
        QFETCH(bool, confirmed);
        QFETCH(int, sorties);
        Flight flight;
        flight.lane(3.0, Vec3::Zero());
        flight.book.takeSent(protocol::SetInsPose{.base_in_map = {.position_m = {-to_x_m, 9.0, 6.0}}});
        if (confirmed)
            flight.book.take(
                protocol::InfoLine{{1000000}, "RES", protocol::Response{.type = "INS", .name = "INS", .ok = true}, {}});
        flight.lane(9.0, Vec3::Zero());
        QCOMPARE(flight.book.mapper().store().sorties().size(), std::size_t(sorties));
    }
};

USAR_TEST(tst_MapAdjuster)

} // namespace tst_map_adjuster

#include "tst_map_adjuster.moc"
