#include <algorithm>
#include <map>
#include <set>

#include <QTest>

#include "core/campaign/plan/planned_run.h"
#include "core/campaign/runs/shard_file.h"
#include "tests/suite/suite.h"

namespace tst_planned_run {

using namespace usar;
using namespace usar::campaign;

namespace {

const std::vector<FaultChoice> choices{{"wind", {{"speed", 0.0, 4.0, 30.0}}}, {"vanish", {}}, {"link_cut", {}}};

Campaign twoByTwo() {
    Campaign campaign;
    campaign.name = "Two by two";
    campaign.missions = {{"/m/a.json", 1, 3, {}, {{"area.x", -5.0, 5.0, {}}}},
                         {"/m/b.json", 7, 2, {"town", "quarry"}, {{"start", 0.0, 0.0, {"Hill", "Dale"}}}}};
    campaign.variants = {{"plain", "airrobot/cpp", {}, {}},
                         {"high", "airrobot/cpp", "/p/p.lap", {"parameters.altitude_m=9"}}};
    campaign.swarm = Swarm{0.5, 0.0, 100.0, {}};
    return campaign;
}

} // namespace

class tst_PlannedRun : public QObject {
    Q_OBJECT
private slots:
    void everyCombinationIsThereOnce() {
        const auto runs = planRuns(twoByTwo(), choices);
        QCOMPARE(runs.size(), std::size_t(2 * (3 + 2 * 2)));
        std::set<std::tuple<std::size_t, std::size_t, std::uint64_t, std::string>> seen;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            QCOMPARE(runs[i].number, static_cast<int>(i));
            seen.insert({runs[i].mission, runs[i].variant, runs[i].seed, runs[i].values.front()});
        }
        QCOMPARE(seen.size(), runs.size());
        QCOMPARE(runs.back().seed, std::uint64_t(8));
    }

    void variantsShareAllThatIsDrawn() {
        std::map<int, std::vector<PlannedRun>> pairs;
        for (const PlannedRun& run : planRuns(twoByTwo(), choices))
            pairs[run.pair].push_back(run);
        for (const auto& [pair, runs] : pairs) {
            QCOMPARE(runs.size(), std::size_t(2));
            QCOMPARE(runs[0].seed, runs[1].seed);
            QVERIFY(runs[0].faults == runs[1].faults);
            auto values = runs[0].values;
            values.push_back("parameters.altitude_m=9");
            QVERIFY(values == runs[1].values);
        }
    }

    void drawsDependOnTheSeedAlone() {
        const auto runs = planRuns(twoByTwo(), choices);
        QVERIFY(runs == planRuns(twoByTwo(), choices));
        std::set<std::string> drawn;
        for (int i = 0; i < 3; ++i)
            drawn.insert(runs[static_cast<std::size_t>(2 * i)].values.front());
        QCOMPARE(drawn.size(), std::size_t(3));
        Campaign more = twoByTwo();
        more.missions.front().seeds = 4;
        const auto more_runs = planRuns(more, choices);
        for (std::size_t i = 0; i < 6; ++i)
            QVERIFY(runs[i] == more_runs[i]);
    }

    void shardsDivideTheRunsAndNoPair() {
        const auto runs = planRuns(twoByTwo(), choices);
        std::map<int, int> shard_of_pair;
        for (const PlannedRun& run : runs) {
            int owners = 0;
            for (int i = 0; i < 3; ++i) {
                if (!Shard{i, 3}.has(run))
                    continue;
                ++owners;
                QCOMPARE(shard_of_pair.try_emplace(run.pair, i).first->second, i);
            }
            QCOMPARE(owners, 1);
        }
    }

    void theCommandCanBePastedIntoAShell() {
        Campaign campaign = twoByTwo();
        campaign.missions.front().file = "/my missions/it's.json";
        campaign.faults = {"wind speed=3"};
        campaign.swarm.reset();
        campaign.limit_h = 1.5;
        const auto runs = planRuns(campaign, choices);
        const QString value = QString::fromStdString(runs[1].values.front());
        QCOMPARE(
            commandOf(campaign, runs[1]),
            "usar-mission run '/my missions/it'\\''s.json' --seed 1 --behavior airrobot/cpp --plan /p/p.lap --set " +
                value + " --set parameters.altitude_m=9 --fault 'wind speed=3' --limit 1.5h");
    }

    void aWorldMayBeMadeFromTheSeed() {
        Campaign campaign = twoByTwo();
        campaign.missions = {{"/m/b.json", 7, 2, {"town:seed", "town:3"}, {}}};
        std::vector<std::string> worlds;
        for (const PlannedRun& run : planRuns(campaign, choices))
            if (run.variant == 0)
                worlds.push_back(run.values.front());
        QVERIFY(worlds == (std::vector<std::string>{"world=town:7", "world=town:8", "world=town:3", "world=town:3"}));
    }

    void knownFailuresAreFlownAfterTheOthers() {
        Campaign campaign = twoByTwo();
        const auto without = planRuns(campaign, choices);
        campaign.again = {{"b", "high", 99, {"vanish from=3.0"}, {"world=town"}, "It crashed."}};
        const auto runs = planRuns(campaign, choices);
        QCOMPARE(runs.size(), without.size() + 1);
        for (std::size_t i = 0; i < without.size(); ++i)
            QVERIFY(runs[i] == without[i]);
        const PlannedRun expected{
            static_cast<int>(without.size()),         without.back().pair + 1, 1, 1, 99, {"vanish from=3.0"},
            {"world=town", "parameters.altitude_m=9"}};
        QVERIFY(runs.back() == expected);
    }

    void theSwarmLeavesOutKinds() {
        const Swarm swarm{0.3, 10.0, 20.0, {}};
        std::map<std::string, int> counts;
        int early = 0;
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            Random random = seeded(seed, 9);
            for (const std::string& fault : drawFaults(swarm, choices, random)) {
                ++counts[fault.substr(0, fault.find(' '))];
                const double from_s = std::stod(fault.substr(fault.find("from=") + 5));
                early += from_s < 10.0 || from_s > 20.0;
            }
        }
        QCOMPARE(early, 0);
        QCOMPARE(counts.size(), choices.size());
        for (const auto& [word, count] : counts) // 600 expected; 4 standard deviations are 82.
            QVERIFY2(std::abs(count - 600) < 82, word.c_str());
    }

    void theSwarmMayBeOfSomeKindsOnly() {
        Random random = seeded(1, 1);
        const auto faults = drawFaults({1.0, 0.0, 0.0, {"vanish"}}, choices, random);
        QCOMPARE(faults.size(), std::size_t(1));
        QVERIFY(faults.front().starts_with("vanish from=0.0"));
    }
};

USAR_TEST(tst_PlannedRun)

} // namespace tst_planned_run

#include "tst_planned_run.moc"
