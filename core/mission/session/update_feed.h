// Paces the updates of a session: collects changes and hands them out once per frame.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QTimer>

#include "core/mission/session/update_collector.h"

namespace usar::mission {

/// Collects nothing while nobody observes the session. Belongs to one session and its thread.
class UpdateFeed {
public:
    /// `owner` belongs to the session's thread and must outlive this object. `is_observed` is asked at most once per
    /// frame; `show` must get an update by `take` and hand it out.
    UpdateFeed(QObject& owner, std::function<bool()> is_observed, std::function<void()> show);

    void lookForObservers() { observed_ = is_observed_(); }
    /// Schedules an update within 16 ms because something has changed.
    void touched();
    /// Hands out an update now instead of with the next frame.
    void showNow();
    /// While muted, no updates are handed out; what is added is still collected.
    void mute(bool on);

    void addLine(const protocol::InfoLine& line);
    void addCommand(const agent::CausedCommand& command, std::string text, LineNumber after, Seconds now);
    void addPublished(const std::vector<agent::Published>& published);
    void addTask(ReplayedTask task) { collector_.addTask(std::move(task)); }
    /// Marks in the next update that everything before it is void.
    void rewind() { collector_.rewind(); }
    std::shared_ptr<const SessionUpdate> take(ScanMapper& mapper, const SessionFigures& figures);
    /// Fills in what was measured at the last update.
    void describe(SessionFigures& figures) const { collector_.describe(figures); }

private:
    std::function<bool()> is_observed_;
    std::function<void()> show_;
    QTimer timer_;
    UpdateCollector collector_;
    bool observed_ = false;
    bool muted_ = false;
};

} // namespace usar::mission
