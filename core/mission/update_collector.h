// Gathers what changed until the next frame takes it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>

#include "core/mission/scan_mapper.h"
#include "core/mission/session_update.h"

namespace usar::mission {

/// Bounded in lines, for who shows them may be slower than the server; what is left out is counted. Owned by one
/// session.
class UpdateCollector {
public:
    /// A quarter of a million lines a second: more than one session reads.
    static constexpr std::size_t line_limit = 4000;
    static constexpr double profile_reach_m = 20.0; ///< of the terrain profile, ahead and behind: the belly scanner's

    void addLine(protocol::InfoLine line);
    void addCommand(SentCommand command);
    void addPublished(const std::vector<agent::Published>& published);
    void addTask(ReplayedTask task) { update_.task = std::move(task); }
    /// What is gathered is void, and the next update says so.
    void rewind();
    /// Everything since the last call, with the map's changed tiles; the figures get their rate.
    std::shared_ptr<const SessionUpdate> take(ScanMapper& mapper, SessionFigures& figures);

private:
    void measureRates(SessionFigures& figures);
    /// Counts what goes.
    template <class Item>
    void keepNewest(std::vector<Item>& items);

    SessionUpdate update_;
    std::optional<Pose> base_in_map_; ///< the behavior's newest estimate
    bool moved_ = false;              ///< since the last update
    std::uint64_t lines_not_shown_ = 0;
    QElapsedTimer since_measured_;
    std::uint64_t lines_at_measuring_ = 0;
    protocol::TrafficCounts traffic_at_measuring_;
};

} // namespace usar::mission
