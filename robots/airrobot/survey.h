// Progress over the lanes: what is the goal now, what was done, where to resume.
#pragma once

#include <vector>

#include "core/mapping/coverage_path.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

enum class SurveyEvent { None, LaneEntered, GoalReached, LaneDone, QuadrantDone, AllDone };

/// Walks a coverage plan. A lane is entered at its start, or where it was interrupted, and flown in goals of at most
/// `goal_distance_m`; a goal given up costs only that piece. Map frame. Owned by one behavior; told the position once
/// a tick.
class Survey {
public:
    Survey() = default;
    explicit Survey(mapping::CoveragePlan plan) : plan_(std::move(plan)) {}

    bool done() const { return lane_ >= plan_.lanes.size(); }
    bool onLane() const { return on_lane_; }
    std::size_t laneIndex() const { return lane_; }
    std::size_t laneCount() const { return plan_.lanes.size(); }
    const mapping::CoveragePlan& plan() const { return plan_; }
    int goalsGivenUp() const { return goals_given_up_; }
    /// Length of lane that was left out with the goals given up.
    double givenUp_m() const { return given_up_m_; }
    double givenUp_pct() const { return totalLength_m() > 0.0 ? 100.0 * given_up_m_ / totalLength_m() : 0.0; }

    /// Point to reach next: where the lane is entered, or the end of its present piece.
    Vec2 goal_m(const Settings& settings) const;
    /// Point to steer at: on the lane ahead of the robot, so that it comes back to the lane after a detour.
    Vec2 aim_m(const Vec2& position_m, const Settings& settings) const;

    /// Once a tick: how far along the lane it has come.
    void note(const Vec2& position_m);
    /// The present goal is reached: where the lane is entered, or the end of its piece. Not when all is done.
    bool goalReached(const Vec2& position_m, const Settings& settings) const;
    /// Goes on to the goal after one that was reached.
    SurveyEvent next(const Settings& settings);
    /// All three.
    SurveyEvent update(const Vec2& position_m, const Settings& settings);
    /// The next goal after one that cannot be reached.
    SurveyEvent giveUp(const Settings& settings);
    /// The robot leaves (battery): later the lane is entered where it is left now.
    void interrupt();

    double doneLength_m() const;
    double totalLength_m() const { return plan_.lane_length_m; }
    /// All lane ends in flying order.
    std::vector<Vec2> corners_m() const;

private:
    struct Place {
        double along_m = 0.0; ///< the lane, from its start
        double aside_m = 0.0;
    };
    Place placeOf(const Vec2& position_m) const;
    double length_m() const;
    Vec2 pointAt_m(double along_m) const;
    double pieceEnd_m(const Settings& settings) const;
    SurveyEvent endPiece(const Settings& settings);
    SurveyEvent nextLane();

    mapping::CoveragePlan plan_;
    std::size_t lane_ = 0;
    double finished_lanes_m_ = 0.0;
    bool on_lane_ = false;
    double entry_along_m_ = 0.0;
    double piece_start_m_ = 0.0; ///< everything before it was flown or given up
    double reached_m_ = 0.0;     ///< farthest point of the lane flown
    int goals_given_up_ = 0;
    double given_up_m_ = 0.0;
};

} // namespace usar::airrobot
