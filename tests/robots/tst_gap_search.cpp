// Lanes past what a survey has not shown.
#include <QObject>
#include <QTest>

#include "robots/airrobot/gap_search.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_gap_search {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_GapSearch : public QObject {
    Q_OBJECT

    const Rectangle area{{0, 0}, {40, 20}};

    /// A ledger of scans that show all of the area but these rectangles.
    ScanLedger ledgerWithout(const std::vector<Rectangle>& hidden) const {
        ScanLedger ledger(area);
        Senses senses = sensesAt({20, 10, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = 0.25; x_m < 40.0; x_m += 0.5)
            for (double y_m = 0.25; y_m < 20.0; y_m += 0.5)
                if (std::ranges::none_of(hidden, [&](const Rectangle& one) { return one.contains({x_m, y_m}); }))
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, true, true);
        return ledger;
    }
    /// Everything north of `wall_y_m` is out of reach and out of sight.
    static GapSearch::Surroundings southOf(double wall_y_m) {
        RouteMap map;
        Senses senses = sensesAt({20, 1, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = -108.0; x_m <= 147.0; x_m += 0.25)
            senses.scan->hits_in_map_m.emplace_back(x_m, wall_y_m, 8.0);
        map.take(senses, 1e9);
        return {map.reach({20, 1}, 6.0),
                [map](const Vec2& from_m, const Vec2& to_m) { return map.isInSight(from_m, to_m, 6.0); }};
    }

private slots:
    void tellsHowMuchWithinReachWasMissed_data() {
        QTest::addColumn<Rectangle>("hidden");
        QTest::addColumn<double>("wall_y_m");
        QTest::addColumn<double>("share");
        QTest::newRow("nothing") << Rectangle{{0, 0}, {0, 0}} << 18.0 << 0.0;
        QTest::newRow("a square that is wider than a glance") << Rectangle{{10, 4}, {20, 14}} << 18.0 << 0.125;
        QTest::newRow("beyond the wall") << Rectangle{{10, 13}, {20, 20}} << 12.0 << 0.0;
    }
    void tellsHowMuchWithinReachWasMissed() {
        QFETCH(Rectangle, hidden);
        QFETCH(double, wall_y_m);
        QFETCH(double, share);
        const double missed = GapSearch::missed(ledgerWithout({hidden}), southOf(wall_y_m));
        QVERIFY2(std::abs(missed - share) < 0.01, qPrintable(QString::number(missed)));
    }

    void leadsPastWhatCanBeSeen_data() {
        QTest::addColumn<Rectangle>("hidden");
        QTest::addColumn<double>("wall_y_m");
        QTest::addColumn<int>("lanes");
        QTest::newRow("a strip beside the wall") << Rectangle{{10, 16}, {16, 18}} << 18.0 << 1;
        QTest::newRow("the whole length of a wall") << Rectangle{{0, 16}, {40, 18}} << 18.0 << 4;
        QTest::newRow("beyond the wall") << Rectangle{{10, 13}, {16, 18}} << 12.0 << 0;
        QTest::newRow("too small to matter") << Rectangle{{10, 15}, {13, 18}} << 18.0 << 0;
        QTest::newRow("nothing") << Rectangle{{0, 0}, {0, 0}} << 18.0 << 0;
    }
    void leadsPastWhatCanBeSeen() {
        QFETCH(Rectangle, hidden);
        QFETCH(double, wall_y_m);
        QFETCH(int, lanes);
        const ScanLedger ledger = ledgerWithout({hidden});
        const GapSearch::Surroundings surroundings = southOf(wall_y_m);
        GapSearch search;
        const auto found = search.lanes(ledger, surroundings, {20, 1});
        QCOMPARE(static_cast<int>(found.size()) > 1 ? 4 : static_cast<int>(found.size()), lanes);
        Vec2 from_m(20, 1);
        double hidden_to_m = 0.0;
        for (const mapping::Lane& lane : found) {
            QVERIFY((lane.start_m - from_m).norm() <= (lane.end_m - from_m).norm());
            QVERIFY(surroundings.reach.contains(lane.start_m) && surroundings.reach.contains(lane.end_m));
            QVERIFY((lane.end_m - lane.start_m).norm() < 13.0);
            QVERIFY(std::abs((lane.end_m - lane.start_m).normalized().x()) > 0.9); // along the wall
            QVERIFY(lane.start_m.y() > 14.0 && lane.start_m.y() < 17.0);
            hidden_to_m = std::max({hidden_to_m, lane.start_m.x(), lane.end_m.x()});
            from_m = lane.end_m;
        }
        QVERIFY(found.empty() || hidden_to_m > hidden.max_m.x() - 4.0);
        for (const mapping::Lane& across : search.lanes(ledger, surroundings, {20, 1})) // Each gap is tried twice.
            QVERIFY(surroundings.reach.contains(across.start_m) || surroundings.reach.contains(across.end_m));
        QVERIFY(search.lanes(ledger, surroundings, {20, 1}).empty());
    }

    // A lane along a wall ends before the next wall, and leaves the corner out (random survey 115073).
    void triesAGapOnceMorePastItsMiddle() {
        const ScanLedger ledger = ledgerWithout({{{10, 14}, {16, 18}}});
        const GapSearch::Surroundings surroundings = southOf(18.0);
        GapSearch search;
        const auto first = search.lanes(ledger, surroundings, {20, 1});
        const auto second = search.lanes(ledger, surroundings, {20, 1});
        QCOMPARE(first.size(), std::size_t(1));
        QCOMPARE(second.size(), std::size_t(1));
        QVERIFY((first[0].end_m - first[0].start_m).norm() > 4.5);
        QVERIFY((second[0].end_m - second[0].start_m).norm() < 4.1);
        QVERIFY(std::abs((second[0].end_m + second[0].start_m).x() / 2.0 - 13.0) < 1.5);
    }

    // Behind a shelf, one lane shows a strip of each cell, and the map has holes beside it (random survey 115089).
    void leadsPastCellsThatWereSeenInPart_data() {
        QTest::addColumn<double>("wall_y_m");
        QTest::addColumn<bool>("leads");
        QTest::newRow("in the open") << 18.0 << true;
        QTest::newRow("behind a wall") << 8.75 << false;
    }
    void leadsPastCellsThatWereSeenInPart() {
        QFETCH(double, wall_y_m);
        QFETCH(bool, leads);
        ScanLedger ledger(area);
        Senses senses = sensesAt({20, 10, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = 0.25; x_m < 40.0; x_m += 0.5)
            for (double y_m = 0.25; y_m < 20.0; y_m += 0.5)
                if (y_m < 9.0 || (wall_y_m > 9.0 && y_m > 9.5)) // A strip of half a meter is missing, or all beyond it.
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        if (wall_y_m < 9.0)
            for (double x_m = 0.25; x_m < 40.0; x_m += 0.5) // Some of the wall's own cells count as seen.
                senses.scan->hits_in_map_m.emplace_back(x_m, 9.75, 0.0);
        ledger.note(senses, true, true);
        GapSearch search;
        QCOMPARE(!search.lanes(ledger, southOf(wall_y_m), {20, 1}).empty(), leads);
    }

    // The scanner looks to the sides, so a lane that leads toward the gap does not show it.
    void passesASmallGapSideways() {
        const ScanLedger ledger = ledgerWithout({{{10, 16}, {12, 20}}, {{30, 16}, {32, 20}}});
        GapSearch search;
        const auto found = search.lanes(ledger, southOf(21.0), {20, 1});
        QCOMPARE(found.size(), std::size_t(2));
        for (const mapping::Lane& lane : found)
            QVERIFY((lane.end_m - lane.start_m).norm() >= 3.0);
    }

    void doesNotWatchWhatIsTooLarge() {
        GapSearch search;
        QVERIFY(search.lanes(ScanLedger({{0, 0}, {20000, 20000}}), southOf(18.0), {20, 1}).empty());
    }
};

USAR_TEST(tst_GapSearch)

} // namespace tst_gap_search

#include "tst_gap_search.moc"
