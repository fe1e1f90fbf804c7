// The marks of a robot under TRACE, from what its session sees: on any server, and in a replay.
#pragma once

#include <optional>
#include <vector>

#include "core/mission/session_update.h"
#include "core/protocol/trace_pen.h"

namespace usar::mission {

struct TraceSpot {
    protocol::TraceColor color = protocol::TraceColor::Red;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const TraceSpot&) const = default;
};

/// One robot's. A server draws its marks in its own game and tells nobody, so they are found again here: from the TRACE
/// that went out and the poses that came in; ground truth where the robot has it, else INS, else what the behavior
/// believes. Values only, no thread of its own.
class TraceWatch {
public:
    /// Marks of this update, in order.
    std::vector<TraceSpot> take(const SessionUpdate& update);
    bool on() const { return pen_.on(); }
    protocol::TraceColor color() const { return pen_.color(); }

private:
    enum class Source { Belief, Ins, GroundTruth };
    void obey(const SentCommand& command);
    void move(Source source, Seconds now, const Vec3& position_m, std::vector<TraceSpot>& spots);

    protocol::TracePen pen_;
    Source best_ = Source::Belief;
    Seconds now_{0.0};
};

} // namespace usar::mission
