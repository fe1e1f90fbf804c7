#include "widgets/models/series_store.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace usar::widgets {

namespace {

constexpr double another_run_s = 1.0;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Returns the value to draw: a number, 0 or 1 for a flag, NaN (a gap) for "nan"; nullopt for other texts.
std::optional<double> drawable(const protocol::Field& field) {
    if (field.number)
        return std::isfinite(*field.number) ? *field.number : no_number;
    if (field.text == "True")
        return 1.0;
    if (field.text == "False")
        return 0.0;
    return field.text == "nan" ? std::optional(no_number) : std::nullopt;
}

} // namespace

bool SeriesStore::add(const SeriesKey& key, const std::string& unit) {
    if (key.path.empty() || find(key))
        return false;
    series_.push_back({key, unit, empty_});
    return true;
}

void SeriesStore::keepOnly(const std::vector<SeriesKey>& keys) {
    std::erase_if(series_, [&](const Series& series) { return std::ranges::find(keys, series.key) == keys.end(); });
    std::erase_if(newest_s_, [&](const auto& robot) {
        return std::ranges::none_of(series_, [&](const Series& series) { return series.key.robot == robot.first; });
    });
}

const Series* SeriesStore::find(const SeriesKey& key) const {
    const auto found = std::ranges::find(series_, key, &Series::key);
    return found == series_.end() ? nullptr : &*found;
}

std::optional<double> SeriesStore::newestTime_s(const std::string& robot) const {
    const auto found = newest_s_.find(robot);
    return found == newest_s_.end() ? std::nullopt : std::optional(found->second);
}

bool SeriesStore::take(const std::string& robot, const protocol::InfoLine& line, Seconds now) {
    const auto ofRobot = [&](const Series& series) { return series.key.robot == robot; };
    if (std::ranges::none_of(series_, ofRobot))
        return false;
    const double time_s = protocol::timeOf(line.message).value_or(now).count();
    if (!std::isfinite(time_s))
        return false;
    if (const std::optional<double> newest_s = newestTime_s(robot); newest_s && time_s < *newest_s - another_run_s)
        startAgain(robot);
    newest_s_[robot] = std::max(newestTime_s(robot).value_or(time_s), time_s);
    bool any = false;
    for (const protocol::Field& field : protocol::fieldsOf(line.message)) {
        const std::string path = field.path();
        for (Series& series : series_)
            if (ofRobot(series) && series.key.path == path) {
                append(series, field, time_s);
                any = true;
            }
    }
    return any;
}

void SeriesStore::startAgain(const std::string& robot) {
    for (Series& series : series_)
        if (series.key.robot == robot)
            series.samples.clear();
    newest_s_.erase(robot);
}

void SeriesStore::append(Series& series, const protocol::Field& field, double time_s) {
    const std::optional<double> value = drawable(field);
    if (!value || (!series.samples.empty() && time_s < series.samples.newest_s()))
        return;
    if (series.samples.empty() && series.unit.empty())
        series.unit = field.unit;
    series.samples.append({time_s, *value});
}

} // namespace usar::widgets
