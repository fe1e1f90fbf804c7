// Lanes across those of a survey, past what crowns hid from them.
#include <QObject>
#include <QTest>

#include "robots/airrobot/cross_lanes.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_cross_lanes {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_CrossLanes : public QObject {
    Q_OBJECT

    const Rectangle area{{-50, -30}, {50, 30}};

    /// A ledger whose quarters were all hit but those whose middles are in one of these rectangles.
    ScanLedger ledgerWithout(const std::vector<Rectangle>& hidden) const { return ledgerOf(area, hidden); }
    static ScanLedger ledgerOf(const Rectangle& area, const std::vector<Rectangle>& hidden) {
        ScanLedger ledger(area);
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = area.min_m.x() + 0.25; x_m < area.max_m.x(); x_m += 0.5)
            for (double y_m = area.min_m.y() + 0.25; y_m < area.max_m.y(); y_m += 0.5)
                if (std::ranges::none_of(hidden, [&](const Rectangle& one) { return one.contains({x_m, y_m}); }))
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, true, true);
        return ledger;
    }

private slots:
    void leadsPastWhatIsHidden_data() {
        QTest::addColumn<QList<Rectangle>>("hidden");
        QTest::addColumn<int>("lanes");
        QTest::addColumn<bool>("along_x");
        QTest::newRow("nothing") << QList<Rectangle>{} << 0 << false;
        QTest::newRow("too little") << QList<Rectangle>{{{0, 0}, {2, 4}}} << 0 << false;
        QTest::newRow("a strip across") << QList<Rectangle>{{{10, -28}, {14, 28}}} << 1 << false;
        QTest::newRow("a strip along") << QList<Rectangle>{{{-40, 6}, {40, 9}}} << 1 << true;
        QTest::newRow("half of each cell of a strip") << QList<Rectangle>{} << 1 << true;
        QTest::newRow("where the robot did not get") << QList<Rectangle>{{{-50, -30}, {-10, 30}}} << 0 << false;
        QTest::newRow("a ravine, wider than a crown") << QList<Rectangle>{{{-40, -6}, {40, 6}}} << 1 << true;
        QTest::newRow("two strips far apart")
            << QList<Rectangle>{{{-40, -28}, {-36, 28}}, {{36, -28}, {40, 28}}} << 2 << false;
    }
    void leadsPastWhatIsHidden() {
        QFETCH(QList<Rectangle>, hidden);
        QFETCH(int, lanes);
        QFETCH(bool, along_x);
        if (lanes == 1 && hidden.isEmpty())
            for (double x_m = -40.0; x_m < 40.0; x_m += 1.0)
                hidden << Rectangle{{x_m, 4.0}, {x_m + 0.5, 10.0}};
        const auto found =
            crossLanes(ledgerWithout({hidden.begin(), hidden.end()}), {0.6, 1000.0, 0.5}, {0, 0}, {0, 0});
        QCOMPARE(static_cast<int>(found.size()), lanes);
        for (const mapping::Lane& lane : found) {
            const Vec2 way_m = lane.end_m - lane.start_m;
            QCOMPARE(std::abs(way_m.x()) > std::abs(way_m.y()), along_x);
            const Vec2 middle_m = lane.start_m + way_m / 2.0;
            QVERIFY(std::ranges::any_of(hidden, [&](const Rectangle& one) {
                return one.contains(along_x ? Vec2(one.center_m().x(), middle_m.y())
                                            : Vec2(middle_m.x(), one.center_m().y()));
            }));
            QVERIFY(way_m.norm() > 50.0);
        }
    }

    /// Ground that two lanes show counts once, the lanes are flown on from one another, and their length is limited.
    void choosesTheBestFirst() {
        const std::vector<Rectangle> hidden{{{-40, -28}, {-36, 28}}, {{30, -28}, {38, 28}}};
        const ScanLedger ledger = ledgerWithout(hidden);
        const auto both = crossLanes(ledger, {0.6, 1000.0, 0.5}, {50, -30}, {50, -30});
        QCOMPARE(both.size(), std::size_t(2));
        QVERIFY(both[0].start_m.x() > 0.0 && both[1].start_m.x() < 0.0); // the nearer one first
        QVERIFY((both[0].start_m - Vec2(50, -30)).norm() < (both[0].end_m - Vec2(50, -30)).norm());
        QVERIFY((both[1].start_m - both[0].end_m).norm() < (both[1].end_m - both[0].end_m).norm());
        const auto one = crossLanes(ledger, {0.6, 40.0, 0.5}, {-50, -30}, {-50, -30});
        QCOMPARE(one.size(), std::size_t(1));
        QVERIFY(one[0].start_m.x() > 0.0); // the wider one, as far as it may go
        QVERIFY((one[0].end_m - one[0].start_m).norm() < 40.0);
        QVERIFY((one[0].end_m - one[0].start_m).norm() > 35.0);
    }

    /// Crowns that hide the ground from a lane along it hide it from another one.
    void isNotSentWhereItWas_data() {
        QTest::addColumn<mapping::Lane>("flown");
        QTest::addColumn<bool>("chosen");
        QTest::newRow("along the strip") << mapping::Lane{{-38, -28}, {-38, 28}} << false;
        QTest::newRow("the other way") << mapping::Lane{{-38.2, 29.8}, {-37.6, -40}} << false;
        QTest::newRow("along a part of it") << mapping::Lane{{-38, -28}, {-38, -20}} << true;
        QTest::newRow("across it") << mapping::Lane{{-50, 0}, {50, 0}} << true;
        QTest::newRow("far from it") << mapping::Lane{{20, -28}, {20, 28}} << true;
        QTest::newRow("out of the area") << mapping::Lane{{-90, -28}, {-90, 28}} << true;
    }
    void isNotSentWhereItWas() {
        QFETCH(mapping::Lane, flown);
        QFETCH(bool, chosen);
        const ScanLedger ledger = ledgerWithout({{{-40, -28}, {-36, 28}}});
        const LaneTerms terms{0.6, 1000.0, 0.5, {}, {flown}};
        QCOMPARE(!crossLanes(ledger, terms, {0, 0}, {0, 0}).empty(), chosen);
    }

    /// The tour ends at home, so what is on the way there comes last.
    void endsNearHome() {
        const ScanLedger ledger = ledgerWithout({{{-40, -28}, {-36, 28}}, {{30, -28}, {38, 28}}});
        for (const double home_x_m : {-60.0, 60.0}) {
            const auto lanes = crossLanes(ledger, {0.6, 1000.0, 0.5}, {-3, 0}, {home_x_m, 0});
            QCOMPARE(lanes.size(), std::size_t(2));
            QVERIFY(lanes[1].end_m.x() * home_x_m > 0.0);
        }
    }

    /// The more a lane must show, the fewer there are.
    void asksForAGain_data() {
        QTest::addColumn<double>("gain_m");
        QTest::addColumn<int>("lanes");
        QTest::newRow("little") << 0.3 << 1;
        QTest::newRow("as much as there is on the whole way") << 0.8 << 1;
        QTest::newRow("as much as there is on the lane") << 1.4 << 0;
        QTest::newRow("more") << 4.0 << 0;
        QTest::newRow("none") << 1000.0 << 0;
    }
    void asksForAGain() {
        QFETCH(double, gain_m);
        QFETCH(int, lanes);
        const ScanLedger ledger = ledgerWithout({{{10, -28}, {12, 28}}});
        QCOMPARE(static_cast<int>(crossLanes(ledger, {gain_m, 1000.0, 0.5}, {0, 0}, {0, 0}).size()), lanes);
    }

    /// A tenth of a small area is worth a lane that so little would not be worth in a large one.
    void showsLessInASmallArea() {
        const Rectangle small{{0, 0}, {10, 10}};
        ScanLedger ledger(small);
        Senses senses = sensesAt({5, 5, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = 0.25; x_m < 10.0; x_m += 0.5)
            for (double y_m = 0.25; y_m < 10.0; y_m += 0.5)
                if (x_m < 8.5)
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, true, true);
        QCOMPARE(crossLanes(ledger, {0.6, 1000.0, 0.5}, {5, 5}, {5, 5}).size(), std::size_t(1));
    }

    /// What a tree hides is a hundredth of such an area; with several trees, 3 to 8 % were missing (survey 118360).
    void showsWhatATreeHidesInASmallArea() {
        const auto lanes = [](const Rectangle& hidden) {
            const ScanLedger ledger = ledgerOf({{-15, -15}, {15, 15}}, {hidden});
            return static_cast<int>(crossLanes(ledger, {0.6, 1000.0, 0.5}, {0, 0}, {0, 0}).size());
        };
        QCOMPARE(lanes({{-2, -2}, {1, 2}}), 1);
        QCOMPARE(lanes({{-1, -1}, {1, 1}}), 0);
    }

    /// The same hole is worth a long way in a small area only, and none if no lanes are wanted.
    void isWorthALongerWayInASmallArea_data() {
        QTest::addColumn<double>("width_m");
        QTest::addColumn<double>("gain_m");
        QTest::addColumn<int>("lanes");
        QTest::newRow("a small area") << 60.0 << 0.67 << 1;
        QTest::newRow("a large one") << 160.0 << 0.67 << 0;
        QTest::newRow("a small area, no lanes wanted") << 60.0 << 1000.0 << 0;
    }
    void isWorthALongerWayInASmallArea() {
        QFETCH(double, width_m);
        QFETCH(double, gain_m);
        QFETCH(int, lanes);
        ScanLedger ledger(Rectangle{{0, 0}, {width_m, 40}});
        Senses senses = sensesAt({5, 5, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = 0.25; x_m < width_m; x_m += 0.5)
            for (double y_m = 0.25; y_m < 40.0; y_m += 0.5)
                if (x_m < 4.0 || x_m > 9.0 || y_m < 35.0)
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, true, true);
        const Vec2 here_m(30, 20);
        QCOMPARE(static_cast<int>(crossLanes(ledger, {gain_m, 1000.0, 0.5}, here_m, here_m).size()), lanes);
    }

    /// A map with points 2 m apart has cells without any, which nothing hides.
    void addsNothingToACoarseMap() {
        const ScanLedger ledger = ledgerWithout({{{10, -28}, {14, 28}}});
        QVERIFY(!crossLanes(ledger, {0.6, 1000.0, 0.5}, {0, 0}, {0, 0}).empty());
        QVERIFY(crossLanes(ledger, {0.6, 1000.0, 2.0}, {0, 0}, {0, 0}).empty());
    }

    /// Beams that end in the air may have been too short: the robot was high above a ravine.
    void whereNoGroundWasInReachItMayStillBe() {
        ScanLedger ledger = ledgerWithout({{{10, -28}, {14, 28}}});
        Senses senses = sensesAt({12, 0, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        senses.scan->scanner_in_map.position_m = {12.5, 0.0, 6.0};
        senses.scan->misses_in_map_m.emplace_back(12.5, 0.1, -14.0);
        ledger.note(senses, true, true);
        QCOMPARE(ledger.at(62, 30), ScanLedger::Cell::Bottomless);
        QCOMPARE(ledger.hidden(62, 30), 1.0);
        senses.scan->misses_in_map_m.clear();
        senses.scan->hits_in_map_m.emplace_back(12.2, 0.2, 0.0);
        ledger.note(senses, true, true);
        QCOMPARE(ledger.hidden(62, 30), 0.75);
        QCOMPARE(ledger.at(62, 30), ScanLedger::Cell::Seen);
    }

    /// What is far from all other lanes must be worth the way there, and a charge if it takes one.
    void isWorthTheWay_data() {
        QTest::addColumn<double>("x_m"); // of the base
        QTest::addColumn<double>("left_m");
        QTest::addColumn<int>("lanes");
        QTest::newRow("near the base") << 15.0 << 1000.0 << 1;
        QTest::newRow("far from the base") << 100.0 << 1000.0 << 0;
        QTest::newRow("near the base, but the battery is empty") << 15.0 << 5.0 << 0;
    }
    void isWorthTheWay() {
        QFETCH(double, x_m);
        QFETCH(double, left_m);
        QFETCH(int, lanes);
        const ScanLedger ledger = ledgerWithout({{{10, -20}, {12, 10}}});
        const LaneTerms terms{0.6, 1000.0, 0.5, {left_m, 1000.0, 150.0}};
        QCOMPARE(static_cast<int>(crossLanes(ledger, terms, {x_m, 0}, {x_m, 0}).size()), lanes);
    }

    void doesNotWatchWhatIsTooLarge() {
        QVERIFY(crossLanes(ScanLedger({{0, 0}, {20000, 20000}}), {0.6, 1000.0, 0.5}, {0, 0}, {0, 0}).empty());
    }
};

USAR_TEST(tst_CrossLanes)

} // namespace tst_cross_lanes

#include "tst_cross_lanes.moc"
