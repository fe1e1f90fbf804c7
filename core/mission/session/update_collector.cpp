#include "core/mission/session/update_collector.h"

#include <iterator>
#include <utility>

namespace usar::mission {

void UpdateCollector::addLine(protocol::InfoLine line) {
    update_.lines.push_back(std::move(line));
    if (update_.lines.size() >= 2 * line_limit) // All at once, so that each line is moved at most once.
        keepNewest(update_.lines);
}

void UpdateCollector::addCommand(SentCommand command) {
    update_.commands.push_back(std::move(command));
    if (update_.commands.size() >= 2 * line_limit)
        keepNewest(update_.commands);
}

template <class Item>
void UpdateCollector::keepNewest(std::vector<Item>& items) {
    if (items.size() <= line_limit)
        return;
    const std::size_t surplus = items.size() - line_limit;
    items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(surplus));
    lines_not_shown_ += surplus;
}

void UpdateCollector::rewind() {
    update_ = {};
    update_.rewound = true;
    base_in_map_.reset();
    moved_ = false;
    rates_ = {};
    lines_per_second_ = 0.0;
}

void UpdateCollector::addPublished(const std::vector<agent::Published>& published) {
    update_.published.insert(update_.published.end(), published.begin(), published.end());
    for (const agent::Published& value : published)
        if (const auto* estimate = std::get_if<agent::PoseEstimate>(&value)) {
            base_in_map_ = estimate->base_in_map;
            moved_ = true;
        }
}

std::shared_ptr<const SessionUpdate> UpdateCollector::take(ScanMapper& mapper, SessionFigures figures) {
    measureRates(figures);
    keepNewest(update_.lines);
    keepNewest(update_.commands);
    describe(figures);
    update_.tiles = mapper.map().takeChangedTiles();
    if (!update_.tiles.empty())
        update_.last_hits = mapper.lastHits();
    if (base_in_map_ && (std::exchange(moved_, false) || !update_.tiles.empty()))
        update_.ground = mapping::courseProfile(mapper.map(), *base_in_map_, profile_reach_m);
    update_.height_range = mapper.map().range();
    update_.figures = std::move(figures);
    return std::make_shared<const SessionUpdate>(std::exchange(update_, {}));
}

void UpdateCollector::describe(SessionFigures& figures) const {
    figures.lines_not_shown = lines_not_shown_;
    figures.lines_per_second = lines_per_second_;
    figures.rates = rates_;
}

void UpdateCollector::measureRates(const SessionFigures& figures) {
    constexpr qint64 span_ms = 500;
    if (!since_measured_.isValid()) {
        since_measured_.start();
        lines_at_measuring_ = figures.lines_received;
        traffic_at_measuring_ = figures.traffic;
        return;
    }
    const qint64 elapsed_ms = since_measured_.elapsed();
    if (elapsed_ms < span_ms)
        return;
    const auto lines = static_cast<double>(figures.lines_received - lines_at_measuring_);
    lines_per_second_ = lines * 1000.0 / static_cast<double>(elapsed_ms);
    lines_at_measuring_ = figures.lines_received;
    const protocol::TrafficCounts& now = figures.traffic;
    const protocol::TrafficCounts& then = traffic_at_measuring_;
    const auto rate = [&](std::uint64_t count, std::uint64_t before) {
        const std::uint64_t more = count < before ? count : count - before; // Less than before means a new connection.
        return static_cast<double>(more) * 1000.0 / static_cast<double>(elapsed_ms);
    };
    rates_ = {rate(now.lines_in, then.lines_in), rate(now.lines_out, then.lines_out), rate(now.bytes_in, then.bytes_in),
              rate(now.bytes_out, then.bytes_out)};
    traffic_at_measuring_ = now;
    since_measured_.restart();
}

} // namespace usar::mission
