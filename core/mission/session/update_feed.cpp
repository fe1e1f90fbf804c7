#include "core/mission/session/update_feed.h"

#include <chrono>
#include <utility>

namespace usar::mission {

namespace {

constexpr std::chrono::milliseconds frame{16};

} // namespace

UpdateFeed::UpdateFeed(QObject& owner, std::function<bool()> is_observed, std::function<void()> show)
    : is_observed_(std::move(is_observed))
    , show_(std::move(show))
    , timer_(&owner) {
    timer_.setSingleShot(true);
    timer_.setInterval(frame);
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { show_(); });
}

void UpdateFeed::touched() {
    if (timer_.isActive() || muted_)
        return;
    lookForObservers();
    if (observed_)
        timer_.start();
}

void UpdateFeed::showNow() {
    if (!observed_)
        return;
    timer_.stop();
    if (!muted_)
        show_();
}

void UpdateFeed::mute(bool on) {
    muted_ = on;
    if (on)
        timer_.stop();
}

void UpdateFeed::addLine(const protocol::InfoLine& line) {
    if (observed_)
        add(update_.lines, line);
}

void UpdateFeed::addCommand(const agent::CausedCommand& command, std::string text, LineNumber after, Seconds now) {
    if (observed_)
        add(update_.commands, {command, std::move(text), after, now});
}

template <class Item>
void UpdateFeed::add(std::vector<Item>& items, Item item) {
    items.push_back(std::move(item));
    if (items.size() >= 2 * line_limit) // All at once, so that each item is moved at most once.
        keepNewest(items);
}

template <class Item>
void UpdateFeed::keepNewest(std::vector<Item>& items) {
    if (items.size() <= line_limit)
        return;
    const std::size_t surplus = items.size() - line_limit;
    items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(surplus));
    lines_not_shown_ += surplus;
}

void UpdateFeed::addPublished(const std::vector<agent::Published>& published) {
    if (!observed_)
        return;
    update_.published.insert(update_.published.end(), published.begin(), published.end());
    for (const agent::Published& value : published)
        if (const auto* estimate = std::get_if<agent::PoseEstimate>(&value)) {
            base_in_map_ = estimate->base_in_map;
            moved_ = true;
        }
}

void UpdateFeed::addTask(ReplayedTask task) {
    update_.task = std::move(task);
    update_.published_before_task = update_.published.size();
}

void UpdateFeed::rewind() {
    update_ = {};
    update_.rewound = true;
    base_in_map_.reset();
    moved_ = false;
    rates_ = {};
    lines_per_second_ = 0.0;
}

std::shared_ptr<const SessionUpdate> UpdateFeed::take(ScanMapper& mapper, SessionFigures figures,
                                                      std::shared_ptr<const std::vector<Vec2>> corrected_path_m) {
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
    update_.corrected_path_m = std::move(corrected_path_m);
    update_.figures = std::move(figures);
    return std::make_shared<const SessionUpdate>(std::exchange(update_, {}));
}

void UpdateFeed::describe(SessionFigures& figures) const {
    figures.lines_not_shown = lines_not_shown_;
    figures.lines_per_second = lines_per_second_;
    figures.rates = rates_;
}

void UpdateFeed::measureRates(const SessionFigures& figures) {
    constexpr qint64 span_ms = 500;
    const bool is_first = !since_measured_.isValid();
    const qint64 elapsed_ms = is_first ? span_ms : since_measured_.elapsed();
    if (elapsed_ms < span_ms)
        return;
    const protocol::TrafficCounts& now = figures.traffic;
    const protocol::TrafficCounts& then = traffic_at_measuring_;
    const auto rate = [&](std::uint64_t count, std::uint64_t before) {
        const std::uint64_t more = count < before ? count : count - before; // Less than before means a new connection.
        return static_cast<double>(more) * 1000.0 / static_cast<double>(elapsed_ms);
    };
    if (!is_first) {
        lines_per_second_ = rate(figures.lines_received, lines_at_measuring_);
        rates_ = {rate(now.lines_in, then.lines_in), rate(now.lines_out, then.lines_out),
                  rate(now.bytes_in, then.bytes_in), rate(now.bytes_out, then.bytes_out)};
    }
    lines_at_measuring_ = figures.lines_received;
    traffic_at_measuring_ = now;
    since_measured_.start();
}

} // namespace usar::mission
