// What one robot's server says: lines become values, are numbered and counted, and tell the time and the robot's state.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/mission/session/complaint_book.h"
#include "core/mission/session/session_update.h"
#include "core/modules/state.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// Belongs to one session and its thread. Line numbers and damaged lines are counted over all connections; the clock,
/// the robot's state and the traffic begin anew with each.
class Incoming {
public:
    void beginConnection();
    /// A replay begins again: no line has come, and no damage is known.
    void rewind();
    /// The next line has the number after this one.
    void continueAfter(LineNumber line);

    /// Reads a line without its line end. The result is valid until the next call.
    const protocol::InfoLine& take(std::string_view text);
    /// Counts what is wrong with a line that was taken; returns it the first time that it occurs.
    std::optional<Complaint> judge(const protocol::InfoLine& line);

    /// Number of the newest line.
    LineNumber newest() const { return {lines_}; }
    /// Number of the line with the newest state of the robot (STA); 0 before the first.
    LineNumber stateLine() const { return state_->line(); }
    /// The protocol's clock; 0 until it is known.
    Seconds now() const { return state_->now(); }
    protocol::VehicleKind kind() const;
    bool batteryIsEmpty() const;
    /// Fills in the clock and the counts of lines, except those that the link counts.
    void describe(SessionFigures& figures) const;

private:
    protocol::Reader reader_;
    std::optional<modules::StateModule> state_{std::in_place}; ///< a new one for each connection
    ComplaintBook complaints_;
    std::uint64_t complaints_before_ = 0; ///< from earlier connections
    std::uint64_t lines_ = 0;
    std::uint64_t unknown_ = 0; ///< lines of unknown type on this connection
};

} // namespace usar::mission
