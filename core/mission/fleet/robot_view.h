// The window's knowledge of one robot: the newest values from its session, and the behavior that it was given.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/agent/parameters.h"
#include "core/base/robot_id.h"
#include "core/mapping/height_map.h"
#include "core/mission/fleet/equipment.h"
#include "core/mission/runs/recorded_scan.h"
#include "core/mission/session/session_orders.h"
#include "core/mission/session/session_update.h"

namespace usar::mission {

/// The identity of a robot, which stays when its replay is rewound.
struct RobotIdentity {
    ConnectionId connection; ///< number of the session, unique while the program runs
    RobotId id;              ///< 1-9, the key that selects it; 0 while no robot is spawned
    SpawnRequest spawn;
    /// State of its own connection.
    link::LinkStatus link;
    double cell_size_m = 0.25;       ///< edge of a height map cell
    bool adjust = false;             ///< the map is corrected where its strips overlap
    std::optional<double> limit_h{}; ///< hours that a behavior may run; absent: no limit
    QString recording;               ///< the file that is replayed; empty: live
    std::string recorded_name;       ///< what the robot was called in it; empty: live, or unknown
    ConnectionId looks_back_on;      ///< `connection` of the live robot whose past this replay shows; 0: none
};

/// Newest values of a robot, for views that show it later or switch to it. Positions are in meters in the map frame; an
/// absent value has not been reported yet.
struct RobotView : RobotIdentity {
    /// Figures of the newest update.
    SessionFigures figures;
    Equipment equipment;
    std::string behavior_id; ///< id of the newest behavior; empty: none was started
    Rectangle area_in_map;   ///< its area; empty: none
    std::optional<agent::BehaviorStatus> status;
    std::optional<agent::BehaviorFinished> finished; ///< absent until it has ended
    SessionFigures figures_at_end;                   ///< as they were when it ended, though lines come after that, too
    std::optional<agent::SonarZones> zones;          ///< as the newest behavior judged them last
    std::optional<Pose> base_in_map; ///< as the behavior estimates it; from the INS until the first status
    std::vector<Vec2> trail_m;       ///< estimated positions, more than 0.2 m apart
    /// See SessionUpdate; null: the map is not corrected.
    std::shared_ptr<const std::vector<Vec2>> corrected_path_m;
    /// Marks that the behavior has published, in their order.
    std::vector<agent::MapMark> marks;
    std::vector<Vec2> planned_m; ///< path that the behavior has planned
    /// The place to which the behavior is heading; absent: none.
    std::optional<Vec3> goal_m;
    /// All tiles of the height map so far, not only the changed ones.
    mapping::HeightTiles tiles;
    std::optional<mapping::HeightRange> height_range; ///< range of the whole height map; absent: the map is empty
    /// Mapped ground behind, under and ahead of the robot.
    std::optional<mapping::CourseProfile> ground;
    std::map<mapping::GridIndex, int> covered_cells; ///< number of known cells in the mission area, by tile
    bool paused = false;                             ///< by the user; cleared when the behavior resumes or ends
    bool unsaved = false;                            ///< something was scanned since the last export
    bool broke = false;                              ///< the behavior failed by itself, and none was started since
    std::optional<agent::PlanHalted> halted;         ///< the plan's halt; absent: it is not halted
};

/// A behavior as it was started, with later changes of its parameters and plan applied.
struct StartedBehavior {
    std::string id;
    Rectangle area_in_map;
    /// By id; parameters that are missing have their defaults.
    std::map<std::string, agent::ParameterValue> parameters;
    std::optional<agent::PlanText> plan; ///< the user's plan; absent: the robot's own
    bool isolated = false;               ///< it runs in a separate process
    /// The run whose rest `area_in_map` is; null: it continues none.
    std::shared_ptr<const RecordedScan> continues{};
};

} // namespace usar::mission
