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
        collector_.addLine(line);
}

void UpdateFeed::addCommand(const agent::CausedCommand& command, std::string text, LineNumber after, Seconds now) {
    if (observed_)
        collector_.addCommand({command, std::move(text), after, now});
}

void UpdateFeed::addPublished(const std::vector<agent::Published>& published) {
    if (observed_)
        collector_.addPublished(published);
}

std::shared_ptr<const SessionUpdate> UpdateFeed::take(ScanMapper& mapper, const SessionFigures& figures) {
    return collector_.take(mapper, figures);
}

} // namespace usar::mission
