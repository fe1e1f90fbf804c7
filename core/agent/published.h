// What a behavior tells the world besides commands. Values only: they cross threads and processes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/alternatives.h"
#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/base/geometry.h"
#include "core/posh/finding.h"

namespace usar::agent {

/// Every tick: the figures of the status strip. Unknown figures are absent.
struct BehaviorStatus {
    Seconds time{0.0};    ///< protocol clock
    Seconds elapsed{0.0}; ///< since the behavior started
    std::string state;    ///< in words: "scanning lane 4 of 9"
    std::optional<double> distance_to_goal_m;
    std::optional<double> battery_used_pct; ///< of the simulated capacity, 0..100
    std::optional<double> range_left_m;     ///< before the reserve is touched
    std::optional<double> progress_pct;     ///< of the whole task, 0..100
    std::optional<Seconds> time_left;       ///< estimate on the protocol clock
    double distance_flown_m = 0.0;
    int charges = 0;
    bool paused = false; ///< by an order; a behavior may end its pause itself
    bool operator==(const BehaviorStatus&) const = default;
};

/// Where the robot believes it is; drives the trail.
struct PoseEstimate {
    Seconds time{0.0};
    Pose base_in_map;
    bool operator==(const PoseEstimate&) const = default;
};

/// The thesis's marks on the height map (figure 4.4).
enum class MarkKind { Path, Diversion, LowRisk, HighRisk, Recharge, Landing, GoalGivenUp };

struct MapMark {
    MarkKind kind = MarkKind::Path;
    Vec3 position_in_map_m = Vec3::Zero();
    Seconds time{0.0};
    LineNumber line;
    bool operator==(const MapMark&) const = default;
};

/// "Put that scan on the map": names the scan's line and where the scanner was when it was taken.
struct ScanPlacement {
    LineNumber scan_line;
    Pose scanner_in_map;
    bool operator==(const ScanPlacement&) const = default;
};

/// The lanes that the behavior means to fly, in order, and where it is heading now.
struct PlannedPath {
    std::vector<Vec2> points_in_map_m;
    bool operator==(const PlannedPath&) const = default;
};
struct CurrentGoal {
    std::optional<Vec3> goal_in_map_m;
    bool operator==(const CurrentGoal&) const = default;
};

/// A sonar's reading judged by the robot's threat zones, for the columns view. Distances in metres.
enum class Risk { None, Low, High };
struct SonarZone {
    std::string name;
    double bearing_rad = 0.0; ///< counter-clockwise positive, robot frame
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

/// Something the person should know; becomes a notification.
struct BehaviorEvent {
    Severity severity = Severity::Note;
    std::string text;
    bool operator==(const BehaviorEvent&) const = default;
};

/// The last word of a behavior. `reason` is a sentence.
struct BehaviorFinished {
    bool success = false;
    std::string reason;
    bool operator==(const BehaviorFinished&) const = default;
};

/// What a POSH plan did since the last one, as a piece of a trace file (core/posh/trace_file.h): put together, the
/// pieces of a run are such a file, with the text of the plan in it.
struct PlanTrace {
    std::string bytes;
    bool operator==(const PlanTrace&) const = default;
};

/// A plan stands still behind a cycle, because a person wants it so; the robot has its safe command. A server that
/// waits for each STEP gets none, so that its time stands still as well.
struct PlanHalted {
    std::uint64_t cycle = 0;         ///< the last that was run
    Seconds time{0.0};               ///< of that cycle, protocol clock
    std::optional<int> breakpoint{}; ///< by its id; none: a step is over
    std::string path{};              ///< of what happened; empty for a step
    std::string reason{};            ///< "before robot ▸ work": a part of a sentence
    bool operator==(const PlanHalted&) const = default;
};
/// It goes on.
struct PlanResumed {
    bool operator==(const PlanResumed&) const = default;
};

/// Kept: what ran goes on where it was, with the new text. Restarted: the new plan begins at its root; body and
/// blackboard are as they were. Refused: the old plan goes on as if nothing had been asked.
enum class PlanFate { Kept, Restarted, Refused };

/// What became of a plan that should take the place of the one that runs.
struct PlanReplaced {
    PlanFate fate = PlanFate::Refused;
    std::string plan_name;     ///< of the new one
    std::uint64_t cycle = 0;   ///< the last of the old one
    std::string reason{};      ///< why it was refused, a sentence; empty where the findings say it
    posh::Findings findings{}; ///< of the new one, warnings too
    bool operator==(const PlanReplaced&) const = default;
};

using PublishedVariant =
    std::variant<BehaviorStatus, PoseEstimate, MapMark, ScanPlacement, PlannedPath, CurrentGoal, SonarZones,
                 BehaviorEvent, BehaviorFinished, PlanTrace, PlanHalted, PlanResumed, PlanReplaced>;

/// What a behavior tells, to be used as the variant; what copies its alternatives is compiled in one place.
class Published : public PublishedVariant {
public:
    Published();
    Published(const Published& other);
    Published(Published&& other) noexcept;
    Published& operator=(const Published& other);
    Published& operator=(Published&& other) noexcept;
    ~Published();

    /// One of the alternatives.
    template <AlternativeOf<PublishedVariant> One>
    Published(One&& one) : PublishedVariant(std::in_place_type<std::decay_t<One>>, std::forward<One>(one)) {}

    bool operator==(const Published& other) const;
    /// The variant has one that its alternatives have not, and meta types ask for it.
    friend bool operator<(const Published&, const Published&) = delete;
};

} // namespace usar::agent
