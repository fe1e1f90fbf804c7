// Collects changes until the next frame takes them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>

#include "core/mission/session/scan_mapper.h"
#include "core/mission/session/session_update.h"
#include "core/protocol/usual_values.h"

namespace usar::mission {

/// The number of lines is bounded, because the receiver may be slower than the server; lines left out are counted.
/// Owned by one session.
class UpdateCollector {
public:
    /// Per frame; a quarter of a million lines a second, more than one session reads.
    static constexpr std::size_t line_limit = 4000;
    /// Length of the terrain profile, ahead and behind: the range of the belly scanner.
    static constexpr double profile_reach_m = protocol::usual_scanner_maximum_m;

    void addLine(protocol::InfoLine line);
    void addCommand(SentCommand command);
    void addPublished(const std::vector<agent::Published>& published);
    void addTask(ReplayedTask task) { update_.task = std::move(task); }
    /// Drops what was collected; the next update says that everything before is void.
    void rewind();
    /// Returns everything since the last call, with the map's changed tiles and the rates measured between the calls.
    std::shared_ptr<const SessionUpdate> take(ScanMapper& mapper, SessionFigures figures);
    /// Fills in the rates and the number of lines left out, as of the last `take`.
    void describe(SessionFigures& figures) const;

private:
    void measureRates(const SessionFigures& figures);
    /// Removes all but the newest items and counts the removed ones.
    template <class Item>
    void keepNewest(std::vector<Item>& items);

    SessionUpdate update_;
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
