// The values that a behavior publishes besides commands. Plain data, which is passed between threads and processes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/base/geometry.h"
#include "core/base/id.h"
#include "core/base/sealed.h"
#include "core/base/time_range.h"
#include "core/posh/model/finding.h"

namespace usar::agent {

/// The values of the status strip, published at every tick. Unknown values are absent.
struct BehaviorStatus {
    Seconds time{0.0};    ///< protocol clock
    Seconds elapsed{0.0}; ///< since the behavior started
    std::string state;    ///< in words: "scanning lane 4 of 9"
    std::optional<double> distance_to_goal_m;
    std::optional<double> battery_used_pct; ///< share of the simulated capacity, 0..100
    std::optional<double> range_left_m;     ///< distance until the reserve is needed
    std::optional<double> progress_pct;     ///< share of the whole task, 0..100
    std::optional<Seconds> time_left;       ///< estimate on the protocol clock
    double distance_flown_m = 0.0;
    int charges = 0;
    bool paused = false;                      ///< by an order; a behavior may end its pause itself
    std::optional<TimeRange> time_left_range; ///< about four of five real ends lie in it
    bool operator==(const BehaviorStatus&) const = default;
};

/// The robot's own estimate of its pose; the trail on the map is made from it.
struct PoseEstimate {
    Seconds time{0.0}; ///< protocol clock
    Pose base_in_map;
    bool operator==(const PoseEstimate&) const = default;
};

/// The kinds of marks on the height map in the thesis (figure 4.4).
enum class MarkKind { Path, Diversion, LowRisk, HighRisk, Recharge, Landing, GoalGivenUp };

/// One mark, with the time and the info line that led to it.
struct MapMark {
    MarkKind kind = MarkKind::Path;
    Vec3 position_in_map_m = Vec3::Zero();
    Seconds time{0.0};
    LineNumber line;
    bool operator==(const MapMark&) const = default;
};

/// Asks for a scan to be written to the map: names the scan's line and the scanner's pose when it was taken.
struct ScanPlacement {
    LineNumber scan_line;
    Pose scanner_in_map;
    bool operator==(const ScanPlacement&) const = default;
};

/// The path that the behavior plans to fly, in order.
struct PlannedPath {
    std::vector<Vec2> points_in_map_m;
    bool operator==(const PlannedPath&) const = default;
};
/// The point to which the robot is heading; absent if there is none.
struct CurrentGoal {
    std::optional<Vec3> goal_in_map_m;
    bool operator==(const CurrentGoal&) const = default;
};

enum class Risk { None, Low, High };
/// A sonar's reading and the risk according to the robot's threat zones, for the columns view.
struct SonarZone {
    std::string name;
    double bearing_rad = 0.0; ///< counterclockwise positive, robot frame
    double range_m = 0.0;
    double maximum_m = 0.0;
    double low_risk_below_m = 0.0;
    double high_risk_below_m = 0.0;
    Risk risk = Risk::None;
    bool operator==(const SonarZone&) const = default;
};
struct SonarZones {
    std::vector<SonarZone> zones; ///< in ring order, left to right
    bool operator==(const SonarZones&) const = default;
};

/// A message for the operator, which becomes a notification.
struct BehaviorEvent {
    Severity severity = Severity::Note;
    std::string text;
    bool operator==(const BehaviorEvent&) const = default;
};
/// The last value of a behavior. `reason` is a sentence.
struct BehaviorFinished {
    bool success = false;
    std::string reason;
    /// The sensors without which it could not begin: types on the wire, with the name of one that is missed ("Sonar
    /// L4").
    std::vector<std::string> sensors_missing = {};
    bool operator==(const BehaviorFinished&) const = default;
};

/// The events of a POSH plan since the last PlanTrace, as a piece of a trace file (core/posh/trace/trace_file.h). The
/// pieces of a run in sequence form such a file, which includes the text of the plan.
struct PlanTrace {
    std::string bytes;
    bool operator==(const PlanTrace&) const = default;
};

/// Identifies one of the user's breakpoints, from 1. The one who sets it chooses the number.
using BreakpointId = Id<struct BreakpointTag, 0>;

/// The plan has halted after a cycle at the user's request, and the robot has its safe command. A server in lockstep
/// gets no STEP, so that its time stands still as well.
struct PlanHalted {
    std::uint64_t cycle = 0;                  ///< number of the last cycle
    Seconds time{0.0};                        ///< time of that cycle, protocol clock
    std::optional<BreakpointId> breakpoint{}; ///< absent after a step or a requested halt
    std::string path{};                       ///< place of the event; empty without a breakpoint
    std::string reason{};                     ///< "before robot ▸ work": part of a sentence
    bool operator==(const PlanHalted&) const = default;
};
/// The halted plan continues.
struct PlanResumed {
    bool operator==(const PlanResumed&) const = default;
};

/// Kept: execution continues at the same place with the new text. Restarted: the new plan begins at its root; body and
/// blackboard are unchanged. Refused: the old plan continues.
enum class PlanFate { Kept, Restarted, Refused };
/// The result of a request to replace the running plan.
struct PlanReplaced {
    PlanFate fate = PlanFate::Refused;
    std::string plan_name;     ///< name of the new plan
    std::uint64_t cycle = 0;   ///< last cycle of the old plan
    std::string reason{};      ///< sentence why it was refused; empty if the findings give the reason
    posh::Findings findings{}; ///< errors and warnings about the new plan
    bool operator==(const PlanReplaced&) const = default;
};

/// All kinds of published values, and a value of any kind.
using PublishedVariant =
    std::variant<BehaviorStatus, PoseEstimate, MapMark, ScanPlacement, PlannedPath, CurrentGoal, SonarZones,
                 BehaviorEvent, BehaviorFinished, PlanTrace, PlanHalted, PlanResumed, PlanReplaced>;
using Published = Sealed<PublishedVariant>;
} // namespace usar::agent

extern template class usar::Sealed<usar::agent::PublishedVariant>;
