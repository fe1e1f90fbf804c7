// Paces the updates of a session: collects changes and hands them out once per frame.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>

#include "core/mission/session/scan_mapper.h"
#include "core/mission/session/session_update.h"
#include "core/protocol/usual_values.h"

namespace usar::mission {

/// Collects nothing while nobody observes the session. The number of lines is bounded, because the receiver may be
/// slower than the server; lines left out are counted. Belongs to one session and its thread.
class UpdateFeed {
public:
    /// Per frame; a quarter of a million lines a second, more than one session reads.
    static constexpr std::size_t line_limit = 4000;
    /// Length of the terrain profile, ahead and behind: the range of the belly scanner.
    static constexpr double profile_reach_m = protocol::usual_scanner_maximum_m;

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
    /// A replayed behavior begins; what was published before belongs to earlier ones.
    void addTask(ReplayedTask task);
    /// Drops what was collected; the next update says that everything before it is void.
    void rewind();
    /// Returns everything since the last call, with the map's changed tiles and the rates measured between the calls.
    std::shared_ptr<const SessionUpdate> take(ScanMapper& mapper, SessionFigures figures,
                                              std::shared_ptr<const std::vector<Vec2>> corrected_path_m);
    /// Fills in the rates and the number of lines left out, as of the last `take`.
    void describe(SessionFigures& figures) const;

private:
    template <class Item>
    void add(std::vector<Item>& items, Item item);
    /// Removes all but the newest items and counts the removed ones.
    template <class Item>
    void keepNewest(std::vector<Item>& items);
    void measureRates(const SessionFigures& figures);

    std::function<bool()> is_observed_;
    std::function<void()> show_;
    QTimer timer_;
    bool observed_ = false;
    bool muted_ = false;
    SessionUpdate update_;            ///< what was collected since the last update
    std::optional<Pose> base_in_map_; ///< the behavior's newest estimate
    bool moved_ = false;              ///< since the last update
    std::uint64_t lines_not_shown_ = 0;
    QElapsedTimer since_measured_;
    std::uint64_t lines_at_measuring_ = 0;
    protocol::TrafficCounts traffic_at_measuring_;
    protocol::TrafficRates rates_;
    double lines_per_second_ = 0.0;
};

} // namespace usar::mission
