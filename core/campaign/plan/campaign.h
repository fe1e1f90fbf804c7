// A campaign: many missions that are flown to be compared, as its file describes them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/base/result.h"
#include "core/campaign/plan/known_failures.h"
#include "core/mission/files/mission_file.h"

namespace usar::campaign {

/// A value of a mission that is drawn anew for each seed, uniformly from a range or from a list of texts.
struct Draw {
    std::string key; ///< as mission::setValue takes it: "area.x"
    double least = 0.0;
    double most = 0.0;                ///< not less than `least`
    std::vector<std::string> choices; ///< empty: a number of the range is drawn
    bool operator==(const Draw&) const = default;
};

/// One mission and the seeds that it is flown with.
struct CampaignMission {
    QString file; ///< an absolute path
    std::uint64_t first_seed = 1;
    int seeds = 1; ///< how many, from the first up
    /// Names, absolute paths of folders, or "town:seed" for one a seed; empty: the mission's own.
    std::vector<std::string> worlds;
    std::vector<Draw> draws;
    std::string name = {}; ///< empty: that of its file without the suffix
    bool operator==(const CampaignMission&) const = default;
};

/// One of the ways to fly that are compared. It flies the same seeds as the others.
struct Variant {
    std::string name;
    std::string behavior;            ///< empty: the mission's
    std::string plan;                ///< absolute path of a POSH plan; empty: the mission's
    std::vector<std::string> values; ///< KEY=VALUE, as mission::setValue takes them
    bool operator==(const Variant&) const = default;
};

/// Faults that are drawn for each seed: first which kinds it has, then when and how strong.
struct Swarm {
    double share = 0.3;             ///< probability of each kind, 0 to 1
    double least_s = 0.0;           ///< they begin between these times of the simulation
    double most_s = 300.0;          ///< not less than `least_s`
    std::vector<std::string> kinds; ///< first words of faults; empty: all kinds
    bool operator==(const Swarm&) const = default;
};

/// Says of which runs the files are kept beside their result lines.
enum class Keep { Nothing, Failures, Everything };

/// Places in a campaign's file, for errors that are found later. Campaigns that mean the same are equal, wherever their
/// values stand.
struct CampaignPlaces {
    std::map<std::string, mission::KeyPlace> by_path; ///< "variants[1].behavior"; empty if no file was read
    bool operator==(const CampaignPlaces&) const { return true; }
};

/// Keys of the file: name, missions [], variants [], seeds, faults [], swarm {share, from_s, kinds}, again, limit_h,
/// wall_limit_s, keep ("nothing", "failures" or "everything"). Again is the path of a file of known failures. A mission
/// is the path of its file, from the campaign's folder, or {file, name, seeds, worlds [], draw {KEY: [least, most] or
/// [text, …]}}. Worlds that are folders begin at the campaign's folder, too. Seeds are a count, from 1 up, or {first,
/// count}. A variant is {name, behavior, plan, set {KEY: value}}. Only name and missions are required.
struct Campaign {
    std::string name;
    std::vector<CampaignMission> missions;
    std::vector<Variant> variants;   ///< at least one
    std::vector<std::string> faults; ///< of every run, in the syntax of --fault
    std::optional<Swarm> swarm;
    QString again_file; ///< an absolute path; empty: none
    std::vector<KnownFailure>
        again; ///< what that file holds, flown after all others; their missions and variants are the campaign's
    std::optional<double> limit_h; ///< of simulated time; absent: the missions' own
    double wall_limit_s = 3600.0;  ///< a run that takes longer is stopped
    Keep keep = Keep::Failures;
    CampaignPlaces places = {};
    bool operator==(const Campaign&) const = default;
};

/// The name of a mission in results and reports. Those of a campaign that was read are all different.
QString nameOf(const CampaignMission& mission);

/// Reads a campaign from JSON text; `file_name` is used in errors and for relative paths. Errors name file, line and
/// column. Missions and plans are not opened, but the file of known failures is.
Result<Campaign> readCampaign(const QByteArray& json, const QString& file_name);
/// Reads a campaign file of at most 1 MiB.
Result<Campaign> readCampaignFile(const QString& path);

} // namespace usar::campaign
