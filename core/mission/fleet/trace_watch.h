// Marks of a robot under TRACE, derived from the updates of its session: works with any server, and in a replay.
#pragma once

#include <vector>

#include "core/mission/session/session_update.h"
#include "core/protocol/trace_pen.h"

namespace usar::mission {

/// One mark on the ground.
struct TraceSpot {
    protocol::TraceColor color = protocol::TraceColor::Red;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const TraceSpot&) const = default;
};

/// For one robot. A server draws the marks in its own game and reports them to nobody, so they are reconstructed here:
/// from the TRACE commands sent and the poses received; from ground truth if the robot has it, else INS, else the
/// behavior's pose estimate. Values only, no thread of its own.
class TraceWatch {
public:
    /// Returns the marks of this update, in order.
    std::vector<TraceSpot> take(const SessionUpdate& update);
    /// True while the robot leaves marks.
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
