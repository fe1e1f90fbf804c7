#include "core/campaign/runs/campaign_start.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <QDir>
#include <QThread>

#include "core/campaign/plan/campaign_places.h"
#include "core/campaign/plan/test_folder.h"
#include "core/campaign/runs/parallel.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/files/scan_record.h"

namespace usar::campaign {

namespace {

/// A file or folder that results depend on; its fields are those of HashedInput.
struct Input {
    QString role;
    QString name;
    QString path;
};

/// Reads and hashes the inputs side by side. Of equal ones, one remains.
Result<void> hashAll(const std::vector<Input>& inputs, Manifest& manifest) {
    std::vector<Result<HashedInput>> hashed(inputs.size());
    inParallel(inputs.size(), [&](std::size_t from_the_end) {
        const std::size_t i = inputs.size() - 1 - from_the_end; // The last is the program, which takes longest.
        hashed[i] = hashInput(inputs[i].role, inputs[i].name, inputs[i].path);
    });
    for (Result<HashedInput>& input : hashed) {
        if (!input)
            return tl::unexpected(input.error());
        if (std::ranges::find(manifest.inputs, *input) == manifest.inputs.end())
            manifest.inputs.push_back(*std::move(input));
    }
    return {};
}

/// The mission as a run flies it, or why it cannot.
Result<mission::Mission> missionOf(const mission::Mission& written, const PlannedRun& run, const Campaign& campaign) {
    const Variant& variant = campaign.variants[run.variant];
    mission::MissionOptions options;
    options.values = mission::textsOf(run.values);
    options.behavior = QString::fromStdString(variant.behavior);
    options.plan = QString::fromStdString(variant.plan);
    mission::Mission flown = written;
    return mission::applyTo(flown, options).map([&] { return std::move(flown); });
}

/// An error of a variant's mission, with its place in the campaign's file if it names none in the mission's.
Error ofVariant(const Campaign& campaign, const PlannedRun& run, Error error) {
    error.what = "in the variant \"" + campaign.variants[run.variant].name + "\", " + error.what;
    return ofRun(campaign, run, std::move(error));
}

/// A plan is known by its file, and with the variant that brings it: if two variants exchange their plans, the
/// manifest must differ.
QString planName(const QString& path, const std::string& variant) {
    const QString file = QFileInfo(path).fileName();
    return variant.empty() ? file : file + " of " + QString::fromStdString(variant);
}

/// Reads the missions as they are written, and adds them.
Result<std::vector<mission::Mission>> readMissions(const Campaign& campaign, std::vector<Input>& inputs) {
    std::vector<mission::Mission> written;
    for (std::size_t i = 0; i < campaign.missions.size(); ++i) {
        const CampaignMission& one = campaign.missions[i];
        auto read = mission::readMissionFile(one.file);
        if (!read && QFileInfo(one.file).isFile())
            return tl::unexpected(read.error());
        if (!read)
            return tl::unexpected(
                atPlace(campaign, {"missions[" + std::to_string(i) + "].file", "missions"}, read.error()));
        written.push_back(*std::move(read));
        inputs.push_back({"mission", nameOf(one), one.file});
    }
    return written;
}

/// Checks the runs' missions and adds them with their worlds and plans.
Result<void> addMissions(const std::vector<PlannedRun>& runs, const Campaign& campaign, const CampaignHost& host,
                         std::vector<Input>& inputs) {
    const auto written = readMissions(campaign, inputs);
    if (!written)
        return tl::unexpected(written.error());
    std::set<std::string> worlds;
    std::set<std::pair<std::string, std::string>> plans;
    std::set<std::tuple<std::size_t, std::size_t, std::vector<std::string>>> checked; // Most runs differ by their seed.
    std::set<std::pair<std::size_t, std::size_t>> flyable; // Reading a plan for each drawn value would take too long.
    for (const PlannedRun& run : runs) {
        if (!checked.emplace(run.mission, run.variant, run.values).second)
            continue;
        const Variant& variant = campaign.variants[run.variant];
        const auto flown = missionOf((*written)[run.mission], run, campaign);
        if (!flown)
            return tl::unexpected(ofVariant(campaign, run, flown.error()));
        if (flyable.emplace(run.mission, run.variant).second)
            if (const auto possible = host.check_mission(*flown); !possible)
                return tl::unexpected(ofVariant(campaign, run, possible.error()));
        if (const QString name = QString::fromStdString(flown->world); worlds.insert(flown->world).second) {
            const auto folder = host.find_world(name);
            if (!folder)
                return tl::unexpected(ofRun(campaign, run, mission::atValue(*flown, "world", folder.error())));
            if (!folder->isEmpty()) // Otherwise the program makes it, and its own hash is among the inputs.
                inputs.push_back({"world", name, *folder});
        }
        const QString plan = QString::fromStdString(flown->plan);
        const std::string flies_it = variant.plan.empty() ? std::string() : variant.name;
        if (!plan.isEmpty() && plans.emplace(flown->plan, flies_it).second)
            inputs.push_back({"plan", planName(plan, flies_it), plan});
    }
    return {};
}

void addPrograms(const CampaignHost& host, std::vector<Input>& inputs) {
    for (const QString& folder : host.plugin_folders)
        for (const QString& name : QDir(folder).entryList({"*.so"}, QDir::Files, QDir::Name))
            inputs.push_back({"plugin", name, QDir(folder).filePath(name)});
    if (!host.robots_folder.isEmpty())
        inputs.push_back({"folder", "robots", host.robots_folder});
    inputs.push_back({"program", QFileInfo(host.program).fileName(), host.program});
}

Result<void> checkFaults(const Campaign& campaign, const CampaignHost& host) {
    for (const std::string& fault : campaign.faults)
        if (auto possible = host.check_fault(fault); !possible)
            return tl::unexpected(atPlace(campaign, {"faults"}, possible.error()));
    for (const KnownFailure& known : campaign.again)
        for (const std::string& fault : known.faults)
            if (auto possible = host.check_fault(fault); !possible)
                return tl::unexpected(atPlace(campaign, {"again"}, possible.error()));
    if (!campaign.swarm)
        return {};
    for (const std::string& kind : campaign.swarm->kinds)
        if (std::ranges::none_of(host.faults, [&](const FaultChoice& choice) { return choice.word == kind; }))
            return tl::unexpected(
                atPlace(campaign, {"swarm.kinds"},
                        {"there is no such kind of fault", kind, "Take one that usar-sim --help lists"}));
    return {};
}

} // namespace

void applyTo(Campaign& campaign, const CampaignOptions& options) {
    std::size_t places = 0; // Each flies every seed.
    for (const CampaignMission& mission : campaign.missions)
        places += std::max<std::size_t>(1, mission.worlds.size());
    const int runs_a_seed = static_cast<int>(places * campaign.variants.size());
    for (CampaignMission& mission : campaign.missions) {
        if (options.runs)
            mission.seeds = (*options.runs + runs_a_seed - 1) / runs_a_seed;
        if (options.first_seed)
            mission.first_seed = static_cast<std::uint64_t>(*options.first_seed);
    }
}

Result<Manifest> manifestOf(const Campaign& campaign, const CampaignHost& host) {
    if (auto possible = checkFaults(campaign, host); !possible)
        return tl::unexpected(possible.error());
    Manifest manifest{campaign.name, host.version, {}, {}, {}, planRuns(campaign, host.faults)};
    for (const CampaignMission& one : campaign.missions)
        manifest.missions.push_back(nameOf(one).toStdString());
    for (const Variant& variant : campaign.variants)
        manifest.variants.push_back(variant.name);
    std::vector<Input> inputs;
    if (auto added = addMissions(manifest.runs, campaign, host, inputs); !added)
        return tl::unexpected(added.error());
    addPrograms(host, inputs);
    if (auto all = hashAll(inputs, manifest); !all)
        return tl::unexpected(all.error());
    return manifest;
}

Result<std::unique_ptr<CampaignRunner>> startCampaign(const CampaignOptions& options, const CampaignHost& host) {
    auto campaign = options.tests.isEmpty() ? readCampaignFile(options.file) : campaignOfTests(options.tests);
    if (!campaign)
        return tl::unexpected(campaign.error());
    applyTo(*campaign, options);
    auto manifest = manifestOf(*campaign, host);
    if (!manifest)
        return tl::unexpected(manifest.error());
    if (const auto kept = keepManifest(toText(*manifest, *campaign), options.folder); !kept)
        return tl::unexpected(kept.error());
    const Shard shard = options.shard.value_or(Shard{});
    auto file = ShardFile::open(options.folder, shard);
    if (!file)
        return tl::unexpected(file.error());
    // Whether a campaign is decided depends on the figures; to go on with it, half a gigabyte need not be parsed.
    const ResultPart part = options.until_decided ? ResultPart::Whole : ResultPart::Head;
    auto earlier = readResults(options.folder, host.version, part);
    if (!earlier)
        return tl::unexpected(earlier.error());
    if (!earlier->empty() && !options.resume && !options.shard)
        return failure("there are results already", options.folder.toStdString(),
                       "Go on with them by --resume, or give another folder with --out");
    const int jobs = options.jobs > 0 ? options.jobs : QThread::idealThreadCount();
    return std::make_unique<CampaignRunner>(*campaign, std::move(manifest->runs), *std::move(earlier),
                                            RunnerOptions{.program = host.program,
                                                          .folder = options.folder,
                                                          .shard = shard,
                                                          .jobs = jobs,
                                                          .check_every = options.check_every,
                                                          .version = host.version},
                                            *std::move(file));
}

} // namespace usar::campaign
