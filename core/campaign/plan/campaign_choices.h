// A campaign as it is chosen in a few fields: one mission, several behaviors, and one parameter with several values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/campaign/plan/campaign.h"

namespace usar::campaign {

/// A behavior that is to fly the mission.
struct ChosenBehavior {
    std::string id;
    std::string title;               ///< It names the variant.
    std::string plan;                ///< Absolute path of a POSH plan; empty: the behavior flies its own.
    std::vector<std::string> values; ///< This behavior has these KEY=VALUE, and others lack them.
    bool operator==(const ChosenBehavior&) const = default;
};

/// What somebody has chosen.
struct CampaignChoices {
    std::string name{};
    QString mission_file{}; ///< It is an absolute path.
    std::uint64_t first_seed = 1;
    int seeds = 1;
    std::vector<ChosenBehavior> behaviors{}; ///< There is at least one.
    std::string parameter{};                 ///< Key of a mission file: "parameters.scan_altitude_m"; empty: none.
    std::string parameter_title{};           ///< People read it in the names of the variants.
    std::vector<double> values{};            ///< They are in the unit of the file; none without a parameter.
    std::vector<std::string> faults{};       ///< Every run has them, in the syntax of --fault.
    std::optional<Swarm> swarm{};
};

/// Makes one variant for each behavior and each value of the parameter. Equal titles of behaviors get their ids added.
Campaign campaignOf(const CampaignChoices& choices);

/// The unit and the words that may stand beside a number, or in its place.
struct ValueWords {
    QString unit{};  ///< It may follow a number: "6 m".
    QString words{}; ///< They may stand for `value`: "by resolution".
    double value = 0.0;
};

/// Reads numbers with commas, semicolons or blanks between them, such as "3, 4.5, 6". The error names the first word
/// that is no number, or a number that is there twice.
Result<std::vector<double>> readValues(const QString& text, const ValueWords& known = {});

} // namespace usar::campaign
