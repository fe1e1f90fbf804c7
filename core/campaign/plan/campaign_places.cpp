#include "core/campaign/plan/campaign_places.h"

#include <algorithm>
#include <utility>

namespace usar::campaign {

namespace {

std::string listed(const char* list, std::size_t index) {
    return std::string(list) + '[' + std::to_string(index) + ']';
}

/// The key of the mission that the error is about: checks name it "--set KEY=VALUE", "parameter ID", "behavior ID" or
/// "world NAME".
std::string keyIn(const std::string& where) {
    const std::string word = where.substr(0, where.find(' '));
    const std::string rest = word.size() < where.size() ? where.substr(word.size() + 1) : std::string();
    if (word == "--set")
        return rest.substr(0, rest.find('='));
    return word == "parameter" ? "parameters." + rest : word;
}

} // namespace

Error atPlace(const Campaign& campaign, const std::vector<std::string>& paths, Error error) {
    for (const std::string& path : paths) {
        const auto found = campaign.places.by_path.find(path);
        if (found == campaign.places.by_path.end())
            continue;
        if (!error.where.empty())
            error.what = error.where + ": " + error.what;
        error.where = found->second.value;
        break;
    }
    return error;
}

Error ofRun(const Campaign& campaign, const PlannedRun& run, Error error) {
    const std::string variant = listed("variants", run.variant);
    const std::string mission = listed("missions", run.mission);
    if (error.where.starts_with(campaign.missions[run.mission].file.toStdString() + ':'))
        return error;
    const std::string key = keyIn(error.where);
    std::vector<std::string> paths{variant + ".set." + key, mission + ".draw." + key};
    if (key == "world")
        paths.push_back(mission + ".worlds");
    for (const char* const own : {".plan", ".behavior", ".name"}) // The plan and its behavior are checked together.
        if (key != "behavior" || std::string(own) != ".plan")
            paths.push_back(variant + own);
    paths.push_back(mission + ".file");
    paths.push_back("missions");
    return atPlace(campaign, paths, std::move(error));
}

} // namespace usar::campaign
