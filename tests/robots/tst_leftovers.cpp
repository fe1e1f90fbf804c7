// Tests which lanes are added to a survey once its own are flown.
#include <QObject>
#include <QTest>

#include "robots/airrobot/leftovers.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_leftovers {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Leftovers : public QObject {
    Q_OBJECT

    const Rectangle area{{-50, -30}, {50, 30}};
    agent::CommandPort port;

    /// One lane of this length, which is flown to its end.
    static Survey surveyOver(double length_m) {
        mapping::CoveragePlan plan;
        plan.lanes = {{{0, 0}, {length_m, 0}, 0}};
        plan.lane_length_m = length_m;
        Survey survey(plan);
        flyAll(survey);
        return survey;
    }
    static void flyAll(Survey& survey) {
        while (!survey.done())
            survey.next(Settings{});
    }
    /// A ledger of the area of which these strips across it were not seen.
    ScanLedger ledgerWithout(const std::vector<double>& strips_x_m) const {
        ScanLedger ledger(area);
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double x_m = area.min_m.x() + 0.25; x_m < area.max_m.x(); x_m += 0.5)
            for (double y_m = area.min_m.y() + 0.25; y_m < area.max_m.y(); y_m += 0.5)
                if (std::ranges::none_of(strips_x_m, [&](double strip_m) { return std::abs(x_m - strip_m) < 2.0; }))
                    senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, true, true);
        return ledger;
    }
    /// A robot that is pressed against something above.
    static void meetCeiling(Craft& craft) {
        craft.senses = sensesAt({0, 0, 6});
        for (int tick = 0; tick < 10; ++tick) {
            craft.overhead.observe(craft.senses, {.climb_m_s = 0.4});
            craft.senses.now += Seconds(0.2);
        }
        QVERIFY(craft.overhead.hasCeiling());
    }
    /// Walls around the base, which is at (0, 0), with a door in the one in the east, as beams show them from above
    /// that see the ground on both sides of it.
    static PlacedScan hallWithDoor() {
        PlacedScan scan{{1}, Pose{Vec3(0.0, 0.0, 8.0)}, Pose{Vec3(0.0, 0.0, 8.0)}, {}};
        for (double along_m = -10.0; along_m <= 10.0; along_m += 0.25) {
            scan.hits_in_map_m.emplace_back(-10.0, along_m, 2.4);
            scan.hits_in_map_m.emplace_back(along_m, -10.0, 2.4);
            scan.hits_in_map_m.emplace_back(along_m, 10.0, 2.4);
            if (std::abs(along_m) > 1.5)
                scan.hits_in_map_m.emplace_back(10.0, along_m, 2.4);
            for (double x_m = -9.0; x_m <= 18.0; x_m += 0.25)
                if (std::abs(along_m) < 9.0 && std::abs(x_m - 10.0) > 0.5)
                    scan.hits_in_map_m.emplace_back(x_m, along_m, 0.0);
        }
        return scan;
    }
    /// Where the robot gets at its usual height: up to the walls.
    static ReachablePlaces reachInHall() {
        RouteMap high;
        Senses senses = sensesAt({0.0, 0.0, 8.0});
        senses.scan = hallWithDoor();
        for (double y_m = -1.5; y_m <= 1.5; y_m += 0.25)
            senses.scan->hits_in_map_m.emplace_back(10.0, y_m, 8.0);
        for (Vec3& hit : senses.scan->hits_in_map_m)
            hit.z() = hit.z() > 1.0 ? 8.0 : 0.0;
        high.take(senses, 1e9);
        return high.reach({0.0, 0.0}, 8.0);
    }
    bool addTo(Survey& survey, Leftovers& leftovers, Craft& craft, const ScanLedger& ledger) {
        return leftovers.addLanes(craft, survey, ledger, {0, 0}, port);
    }

private slots:
    void addsLanesTwiceAtMost() {
        const ScanLedger ledger = ledgerWithout({-30.0, 20.0});
        Survey survey = surveyOver(500.0);
        Leftovers leftovers;
        Craft craft;
        QVERIFY(addTo(survey, leftovers, craft, ledger));
        QCOMPARE(survey.laneCount(), std::size_t(3));
        flyAll(survey);
        QVERIFY(addTo(survey, leftovers, craft, ledger)); // Nothing new was seen.
        flyAll(survey);
        const std::size_t lanes = survey.laneCount();
        QVERIFY(!addTo(survey, leftovers, craft, ledger));
        QCOMPARE(survey.laneCount(), lanes);
    }

    /// After a landing, a strip of two is left to be shown; that beside the lane that was flown stays hidden.
    void choosesAnewAfterALanding() {
        Survey survey = surveyOver(500.0);
        Leftovers leftovers;
        Craft craft;
        QVERIFY(addTo(survey, leftovers, craft, ledgerWithout({-30.0, 20.0})));
        const std::vector<mapping::Lane> flown{{{-30, -28}, {-30, 28}}};
        const auto lanes =
            leftovers.chosenAnew(craft, survey, ledgerWithout({-30.0, 20.0}), {0, 0}, flown, usual_detour);
        QCOMPARE(lanes.size(), std::size_t(1));
        QVERIFY(std::abs(lanes[0].start_m.x() - 20.0) < 2.5);
        const auto none = leftovers.chosenAnew(craft, survey, ledgerWithout({-30.0}), {0, 0}, flown, usual_detour);
        QVERIFY(none.empty());
        flyAll(survey);
        QVERIFY(!addTo(survey, leftovers, craft, ledgerWithout({-30.0}))); // It would ask for what was ruled out.
    }

    void addsHalfOfThePlanAtMost() {
        const ScanLedger ledger = ledgerWithout({-30.0, 20.0});
        Survey survey = surveyOver(140.0);
        Leftovers leftovers;
        Craft craft;
        for (int time = 0; time < 2; ++time) {
            addTo(survey, leftovers, craft, ledger);
            flyAll(survey);
        }
        QVERIFY(survey.totalLength_m() > 140.0 + 50.0);
        QVERIFY(survey.totalLength_m() <= 140.0 + 70.0);
    }

    void addsNoneWhereTheyCouldNotBeFlown_data() {
        QTest::addColumn<bool>("ceiling");
        QTest::addColumn<bool>("may_climb");
        QTest::addColumn<bool>("cut_off");
        QTest::newRow("under a ceiling") << true << true << false;
        QTest::newRow("where a person forbids climbs") << false << false << false;
        QTest::newRow("where a wall has cut lanes off") << false << true << true;
    }
    void addsNoneWhereTheyCouldNotBeFlown() {
        QFETCH(bool, ceiling);
        QFETCH(bool, may_climb);
        QFETCH(bool, cut_off);
        Craft craft;
        craft.settings.climb_over = may_climb;
        if (ceiling)
            meetCeiling(craft);
        mapping::CoveragePlan plan;
        plan.lanes = {{{0, 0}, {500, 0}, 0}};
        plan.lane_length_m = 500.0;
        Survey survey(plan);
        if (cut_off)
            survey.cutOff(Settings{}, [](const Vec2&) { return false; });
        flyAll(survey);
        Leftovers leftovers;
        addTo(survey, leftovers, craft, ledgerWithout({-30.0, 20.0}));
        for (std::size_t i = 1; i < survey.laneCount(); ++i) {
            const mapping::Lane& lane = survey.plan().lanes[i];
            QVERIFY((lane.end_m - lane.start_m).norm() < 15.0); // short lanes past gaps, none across the area
        }
    }

    /// It sank at its base, looked for the door from there among shelves, and came home as low.
    void sinksBeforeADoorAndComesUpBehindItBothWays() {
        Craft craft;
        craft.senses = sensesAt({0.0, 0.0, 0.2});
        craft.forgetPlaces();
        meetCeiling(craft);
        Senses senses = sensesAt({0.0, 0.0, 8.0});
        senses.scan = hallWithDoor();
        craft.ways.take(senses, 1e9, true, true);
        mapping::CoveragePlan plan;
        plan.lanes = {{{20, 0}, {40, 0}, 0}};
        plan.lane_length_m = 20.0;
        Survey survey(plan);
        survey.cutOff(Settings{}, [](const Vec2&) { return false; });
        Leftovers leftovers;
        leftovers.noteWall(reachInHall());
        QVERIFY(addTo(survey, leftovers, craft, ledgerWithout({})));
        const Vec2 before_m = survey.plan().lanes.back().end_m;
        QVERIFY2(before_m.x() > 6.0 && before_m.x() < 9.0 && std::abs(before_m.y()) < 2.0,
                 qPrintable(QString("%1 %2").arg(before_m.x()).arg(before_m.y())));
        const auto passes_at = [&](const Vec2& at_m, double z_m, bool returning) {
            craft.senses = sensesAt({at_m.x(), at_m.y(), z_m});
            return leftovers.passDoor(craft, survey, returning, port);
        };
        flyAll(survey);
        QVERIFY(!passes_at(before_m, 8.0, false));
        QVERIFY(addTo(survey, leftovers, craft, ledgerWithout({})));
        QVERIFY(craft.ways.isUnder());
        QVERIFY(!passes_at({10.0, 0.0}, 2.4, false));
        QVERIFY(passes_at({15.0, 0.0}, 2.4, false));
        QVERIFY(!craft.ways.isUnder());
        QVERIFY(!passes_at({15.0, 0.0}, 8.0, true));
        QVERIFY(craft.ways.isUnder());
        for (const double x_m : {12.0, 10.0, 8.0})
            QVERIFY(!passes_at({x_m, 0.0}, 2.4, true));
        QVERIFY(passes_at({6.0, 0.0}, 2.4, true));
        QVERIFY(!craft.ways.isUnder());
        QVERIFY(!passes_at({5.0, 0.0}, 8.0, true));
    }

    void addsNoneWhereNothingIsHidden() {
        Survey survey = surveyOver(500.0);
        Leftovers leftovers;
        Craft craft;
        QVERIFY(!addTo(survey, leftovers, craft, ledgerWithout({})));
        QVERIFY(leftovers.begun());
    }
};

USAR_TEST(tst_Leftovers)

} // namespace tst_leftovers

#include "tst_leftovers.moc"
