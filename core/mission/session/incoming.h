// Input from one robot's server: parses, numbers and counts its lines, reports what is wrong in them once per kind, and
// derives the time and the robot's state.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/mission/session/session_update.h"
#include "core/modules/state.h"
#include "core/protocol/info_message.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// A problem in a line, in words.
struct Complaint {
    std::string kind; ///< equal for all complaints of one kind
    std::string text;
};

/// Two complaints are of the same kind if their messages are of the same type and their texts differ only in numbers
/// and quoted words. After `kind_limit` kinds, new ones are only counted. Owned by one session.
class ComplaintBook {
public:
    static constexpr std::size_t kind_limit = 20;

    /// Returns a sentence for the user if the line has a problem of a new kind, else nullopt. Diagnostics of severity
    /// Note do not count as problems.
    std::optional<Complaint> take(const protocol::InfoLine& line);
    /// Number of lines with a problem.
    std::uint64_t count() const { return count_; }

private:
    std::set<std::string> kinds_;
    std::uint64_t count_ = 0;
};

/// Belongs to one session and its thread. Line numbers and damaged lines are counted over all connections; the clock,
/// the robot's state and the traffic counts start again with each connection.
class Incoming {
public:
    void beginConnection();
    /// Resets the line numbers and the counts of damaged lines because a replay starts again.
    void rewind();
    /// Gives the next line the number after `line`.
    void continueAfter(LineNumber line);

    /// Reads a line without its line end. The result is valid until the next call.
    const protocol::InfoLine& take(std::string_view text);
    /// Counts the defects of a line that was taken; returns a complaint the first time that its kind occurs.
    std::optional<Complaint> judge(const protocol::InfoLine& line) { return complaints_.take(line); }

    /// Number of the newest line.
    LineNumber newest() const { return {lines_}; }
    /// Number of the line with the newest state of the robot (STA); 0 before the first.
    LineNumber stateLine() const { return state_->line(); }
    /// Time on the protocol clock; 0 until it is known.
    Seconds now() const { return state_->now(); }
    protocol::VehicleKind kind() const;
    bool batteryIsEmpty() const;
    /// Remaining battery, 0..100 percent of the most that the robot has reported on this connection, because
    /// no message tells its capacity; nullopt if it reports none.
    std::optional<double> batteryLeft_pct() const;
    /// Fills in the clock and the counts of lines, except those that the link counts.
    void describe(SessionFigures& figures) const;

private:
    protocol::Reader reader_;
    std::optional<modules::StateModule> state_{std::in_place}; ///< a new one for each connection
    Seconds fullest_battery_{0.0};                             ///< most that was reported on this connection
    ComplaintBook complaints_;
    std::uint64_t complaints_before_ = 0; ///< from earlier connections
    std::uint64_t lines_ = 0;
    std::uint64_t unknown_ = 0; ///< lines of unknown type on this connection
};

} // namespace usar::mission
