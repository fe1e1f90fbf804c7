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
