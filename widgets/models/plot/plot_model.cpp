#include "widgets/models/plot/plot_model.h"

#include <algorithm>

namespace usar::widgets {

void PlotModel::setLayout(PlotLayout layout) {
    if (layout.canvases.empty())
        layout.canvases.emplace_back();
    layout_ = std::move(layout);
    watch();
}

bool PlotModel::add(std::size_t canvas, const std::string& path, const std::string& unit) {
    const PlotSeries entry{robot_, path, unit};
    const auto same = [&](const ShownSeries& each) { return each.canvas == canvas && each.key == keyOf(entry); };
    if (path.empty() || canvas >= layout_.canvases.size() || std::ranges::any_of(shown(), same))
        return false;
    layout_.canvases[canvas].push_back(entry);
    watch();
    return true;
}

bool PlotModel::remove(std::size_t canvas, const SeriesKey& key) {
    if (canvas >= layout_.canvases.size())
        return false;
    const auto gone =
        std::erase_if(layout_.canvases[canvas], [&](const PlotSeries& entry) { return keyOf(entry) == key; });
    watch();
    return gone > 0;
}

void PlotModel::clear() {
    for (std::vector<PlotSeries>& canvas : layout_.canvases)
        canvas.clear();
    watch();
}

bool PlotModel::addCanvas() {
    if (layout_.canvases.size() >= PlotLayout::most_canvases)
        return false;
    layout_.canvases.emplace_back();
    return true;
}

bool PlotModel::removeCanvas(std::size_t canvas) {
    if (canvas >= layout_.canvases.size() || layout_.canvases.size() == 1)
        return false;
    layout_.canvases.erase(layout_.canvases.begin() + static_cast<std::ptrdiff_t>(canvas));
    watch();
    return true;
}

void PlotModel::setFollowRobot(bool follow) {
    layout_.follow_robot = follow;
    watch();
}

void PlotModel::setRobot(const std::string& robot) {
    robot_ = robot;
    watch();
}

void PlotModel::forget(const std::string& robot) {
    robots_.erase(robot);
    watch();
}

bool PlotModel::take(const std::string& robot, const protocol::InfoLine& line, Seconds now) {
    if (robots_.insert(robot).second)
        watch();
    if (!store_.take(robot, line, now))
        return false;
    return std::ranges::any_of(shown(), [&](const ShownSeries& each) { return each.key.robot == robot; });
}

SeriesKey PlotModel::keyOf(const PlotSeries& entry) const {
    return {layout_.follow_robot || entry.robot.empty() ? robot_ : entry.robot, entry.path};
}

void PlotModel::watch() {
    std::vector<SeriesKey> wanted;
    for (const std::vector<PlotSeries>& canvas : layout_.canvases)
        for (const PlotSeries& entry : canvas) {
            const auto want = [&](const std::string& robot) {
                wanted.push_back({robot, entry.path});
                store_.add(wanted.back(), entry.unit);
            };
            want(keyOf(entry).robot);
            if (!entry.robot.empty())
                want(entry.robot);
            if (layout_.follow_robot)
                for (const std::string& robot : robots_)
                    want(robot);
        }
    store_.keepOnly(wanted);
}

std::vector<ShownSeries> PlotModel::shown() const {
    std::vector<ShownSeries> all;
    for (std::size_t canvas = 0; canvas < layout_.canvases.size(); ++canvas)
        for (const PlotSeries& entry : layout_.canvases[canvas]) {
            const SeriesKey key = keyOf(entry);
            const auto same = [&](const ShownSeries& each) { return each.canvas == canvas && each.key == key; };
            if (std::ranges::none_of(all, same))
                all.push_back({key, store_.find(key), canvas, static_cast<int>(all.size())});
        }
    return all;
}

bool PlotModel::empty() const {
    return std::ranges::all_of(layout_.canvases, &std::vector<PlotSeries>::empty);
}

std::optional<double> PlotModel::newest_s() const {
    std::optional<double> newest;
    for (const ShownSeries& each : shown())
        if (const std::optional<double> time_s = store_.newestTime_s(each.key.robot))
            newest = std::max(newest.value_or(*time_s), *time_s);
    return newest ? std::optional(std::min(*newest, until_s_)) : std::nullopt;
}

std::optional<double> PlotModel::oldest_s() const {
    std::optional<double> oldest;
    for (const ShownSeries& each : shown())
        if (const SampleHistory& samples = each.series->samples; !samples.empty())
            oldest = std::min(oldest.value_or(samples.oldest_s()), samples.oldest_s());
    return oldest;
}

void PlotModel::setFrozen(bool frozen) {
    until_s_ = std::numeric_limits<double>::infinity();
    if (frozen)
        until_s_ = newest_s().value_or(until_s_);
}

Statistics PlotModel::statistics(const Series& series, double from_s, double to_s) const {
    if (cursors_.difference_s()) {
        from_s = std::min(*cursors_.a_s, *cursors_.b_s);
        to_s = std::max(*cursors_.a_s, *cursors_.b_s);
    }
    return series.samples.statistics(from_s, std::min(to_s, until_s_));
}

} // namespace usar::widgets
