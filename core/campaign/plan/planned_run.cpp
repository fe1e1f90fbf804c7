#include "core/campaign/plan/planned_run.h"

#include <algorithm>
#include <string_view>

#include "core/base/numbers.h"
#include "core/campaign/plan/shell_word.h"

namespace usar::campaign {

namespace {

/// Engine streams of a pair's draws.
enum Stream : std::uint64_t { Values = 1, Faults = 2 };

/// "town:seed" is the world that the generator makes from the run's own seed.
std::string worldOf(const std::string& world, std::uint64_t seed) {
    constexpr std::string_view own_seed = ":seed";
    return world.ends_with(own_seed) ? world.substr(0, world.size() + 1 - own_seed.size()) + std::to_string(seed)
                                     : world;
}

std::vector<std::string> drawValues(const std::vector<Draw>& draws, std::uint64_t seed) {
    std::vector<std::string> values;
    if (draws.empty())
        return values; // Seeding an engine costs more than the rest of a run's plan.
    Random random = seeded(seed, Values);
    for (const Draw& draw : draws) {
        std::string value;
        if (draw.choices.empty()) {
            value = fixed(uniform(random, draw.least, draw.most), 3);
        } else {
            const auto last = static_cast<double>(draw.choices.size() - 1);
            value = draw.choices[static_cast<std::size_t>(
                std::min(last, uniform(random, 0.0, static_cast<double>(draw.choices.size()))))];
        }
        values.push_back(draw.key + '=' + value);
    }
    return values;
}

void planKnownFailures(const Campaign& campaign, PlannedRun next, std::vector<PlannedRun>& runs) {
    for (const KnownFailure& one : campaign.again) {
        const auto mission = std::ranges::find_if(
            campaign.missions, [&](const auto& candidate) { return nameOf(candidate).toStdString() == one.mission; });
        const auto variant = std::ranges::find(campaign.variants, one.variant, &Variant::name);
        next.mission = static_cast<std::size_t>(mission - campaign.missions.begin());
        next.variant = static_cast<std::size_t>(variant - campaign.variants.begin());
        next.seed = one.seed;
        next.faults = one.faults;
        next.values = one.values;
        std::ranges::copy(variant->values, std::back_inserter(next.values));
        runs.push_back(next);
        ++next.number;
        ++next.pair;
    }
}

} // namespace

std::vector<PlannedRun> planRuns(const Campaign& campaign, std::span<const FaultChoice> choices) {
    std::vector<PlannedRun> runs;
    PlannedRun run;
    const auto addPair = [&](std::uint64_t seed, const std::string& world) {
        const CampaignMission& mission = campaign.missions[run.mission];
        std::vector<std::string> values = drawValues(mission.draws, seed);
        if (!world.empty())
            values.insert(values.begin(), "world=" + worldOf(world, seed));
        run.seed = seed;
        run.faults = campaign.faults;
        if (campaign.swarm) {
            Random random = seeded(seed, Faults);
            std::ranges::move(drawFaults(*campaign.swarm, choices, random), std::back_inserter(run.faults));
        }
        for (run.variant = 0; run.variant < campaign.variants.size(); ++run.variant) {
            run.values = values;
            std::ranges::copy(campaign.variants[run.variant].values, std::back_inserter(run.values));
            runs.push_back(run);
            ++run.number;
        }
        ++run.pair;
    };
    for (run.mission = 0; run.mission < campaign.missions.size(); ++run.mission) {
        const CampaignMission& mission = campaign.missions[run.mission];
        const std::vector<std::string> own_world{std::string()};
        for (const std::string& world : mission.worlds.empty() ? own_world : mission.worlds)
            for (int i = 0; i < mission.seeds; ++i)
                addPair(mission.first_seed + static_cast<std::uint64_t>(i), world);
    }
    planKnownFailures(campaign, run, runs);
    return runs;
}

QStringList argumentsOf(const Campaign& campaign, const PlannedRun& run) {
    const Variant& variant = campaign.variants[run.variant];
    QStringList arguments{"run", campaign.missions[run.mission].file, "--seed", QString::number(run.seed)};
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty())
            arguments << option << QString::fromStdString(value);
    };
    add("--behavior", variant.behavior);
    add("--plan", variant.plan);
    for (const std::string& value : run.values)
        add("--set", value);
    for (const std::string& fault : run.faults)
        add("--fault", fault);
    if (campaign.limit_h)
        arguments << "--limit" << QString::number(*campaign.limit_h) + 'h';
    return arguments;
}

QStringList flightArgumentsOf(const Campaign& campaign, const PlannedRun& run, const QString& folder) {
    // The files of other runs would be deleted at once, and to write them takes a tenth of the time.
    const char* const files = campaign.keep == Keep::Everything ? "always"
                              : campaign.keep == Keep::Failures ? "failed"
                                                                : "never";
    return argumentsOf(campaign, run) << "--course"
                                      << "--one-thread"
                                      << "--files" << files << "--out" << folder;
}

QString commandOf(const Campaign& campaign, const PlannedRun& run) {
    QString command = "usar-mission";
    for (const QString& argument : argumentsOf(campaign, run))
        command += ' ' + shellWord(argument);
    return command;
}

} // namespace usar::campaign
