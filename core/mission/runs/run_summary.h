// Figures of a finished run, and their JSON form.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QStringList>

#include "core/base/clock.h"
#include "core/mission/files/claim.h"
#include "core/mission/files/scan_record.h"
#include "core/mission/runs/mission_score.h"
#include "core/mission/session/session_update.h"

namespace usar::mission {

/// Height above the ground, in meters, of a diving robot since it submerged. The keys are least_height_m, mean_height_m
/// and height_spread_m (standard deviation).
struct HeightOverGround {
    double least_m = 0.0;
    double mean_m = 0.0;
    double spread_m = 0.0;
};

/// Figures of our robot that only a simulator can measure.
struct TrueFigures {
    int collisions = 0;
    double distance_m = 0.0;   ///< path length; key true_distance_m
    Seconds longest_stay{0.0}; ///< longest time within a meter; key longest_stay_s
    int falls = 0;
    int touches = 0;                          ///< contacts with things that can be pushed
    std::optional<Seconds> first_touch{};     ///< since the spawn; key first_touch_s
    std::optional<HeightOverGround> height{}; ///< absent for a robot that has not dived
    bool broken = false;      ///< damaged so badly that it can no longer move; no key: it is a reason of failure
    Seconds powered_for{0.0}; ///< since its battery was empty or a rotor weak, or since the spawn; no key
    /// Collisions within AfterStop::span of the end of the behavior, which `collisions` does not count; nullopt if
    /// nobody has watched.
    std::optional<int> contacts_after_stop{};
    std::vector<Vec3> collision_places_in_map_m{}; ///< the first ones; key course.collisions
};

/// How a run went, for drawings of many runs. JSON, meters in the map frame: coverage is a list of [seconds, percent],
/// given_up a list of [x, y], path a list of [x, y] that is thinned out, and collisions, from the true figures, a list
/// of [x, y].
struct RunCourse {
    std::vector<CoveragePoint> coverage;
    std::vector<Vec2> given_up_in_map_m; ///< goals that the robot gave up
    std::vector<Vec2> path_in_map_m;
};

/// Figures of a run, with or without a window. The JSON keys are the field names unless noted. All of them are
/// present, however the run ended; unknown figures are null. A key speed_x is added: protocol seconds per wall second.
/// A default-constructed summary describes a run that was refused before it began.
struct RunSummary {
    bool success = false;
    std::string reason;
    std::string mission;  ///< empty: unknown
    std::string behavior; ///< empty: unknown
    std::string plan;     ///< path of the user's own plan; empty: none
    std::optional<std::uint64_t> seed;
    /// On the protocol clock; key duration_s. Without a window since the spawn; in the window, where a robot may run
    /// one behavior after another, since the behavior started.
    Seconds duration{0.0};
    Seconds wall{0.0}; ///< wall time since the behavior started; key wall_s
    double distance_m = 0.0;
    int charges = 0;
    std::optional<TrueFigures> truth;
    Score score; ///< keys coverage_pct, rmse_m, rmse_surface_m
    /// Keys reachable_coverage_pct (its `coverage_pct`) and unreachable_m2; absent: unknown.
    std::optional<AreaReach> reach{};
    QStringList warnings{}; ///< sentences about parts of the area that cannot be scanned
    std::size_t cells = 0;  ///< known cells of the whole map
    double filled_m2 = 0.0; ///< surface of the small holes that saved files fill in; `coverage_pct` does not count it
    std::optional<mapping::HeightRange>
        heights; ///< range of the map; absent: it is empty. In the files it is under "map"
    std::uint64_t lines_received = 0;
    std::uint64_t lines_malformed = 0;
    bool lockstep = false;
    std::optional<ContinuedRun> continues{};   ///< key continues: null, or an object with the keys of its fields
    std::optional<MapAdjustment> adjustment{}; ///< key adjustment: null, or an object; without its path and deviation
    QStringList faults;                        ///< injected faults, with their times
    QStringList files;                         ///< full paths of the saved files
    std::vector<ClaimVerdict> claims{};        ///< of the mission; the JSON has the key only if there are any
    std::optional<RunCourse> course{};         ///< absent: nobody has asked for it, and the JSON has no such key
};

/// Facts about a run that only the owner of the simulator knows.
struct SimulatorFacts {
    std::optional<TrueFigures> truth;
    std::optional<std::uint64_t> seed;
    std::function<Truth()> make_truth{};  ///< makes the true heights, in any thread; empty: they are not known
    std::optional<FlightLimits> flight{}; ///< The newest behavior flies by them; absent: it does not fly.
};

/// Adds the line counts and whether the server runs in lockstep.
void addSession(RunSummary& summary, const SessionFigures& figures);
/// Takes the success away from a run whose robot is known to be broken, whatever its behavior says, and adds to the
/// reason.
void judgeDamage(RunSummary& summary);
/// Adds distance, charges, faults and cells, and scores the map (null `truth`: coverage only). With a truth and a
/// flight it also tells what of the area could have been reached. Looks at every cell, so do not call it in the GUI
/// thread.
void addRecord(RunSummary& summary, const ScanRecord& record, const Truth* truth,
               const std::optional<FlightLimits>& flight = std::nullopt);

/// The course of a record, whose last coverage is `coverage_pct`: at most `most` points of its path, with the first and
/// the last one, and as many goals given up.
RunCourse courseOf(const ScanRecord& record, double coverage_pct, std::size_t most = 200);

QJsonObject toJson(const RunSummary& summary);

} // namespace usar::mission
