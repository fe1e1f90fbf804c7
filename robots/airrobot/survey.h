// Progress over the lanes of a survey: the current goal, what is done, and where to resume.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "core/agent/behavior.h"
#include "core/mapping/coverage_path.h"
#include "robots/airrobot/survey_plan.h"

namespace usar::airrobot {

/// The result of completing a goal. SortieDone: the next lane is in another sortie, so the robot may fly home first.
enum class SurveyEvent { LaneEntered, GoalReached, LaneDone, SortieDone, AllDone };

/// Why a goal is left out. NoWayFound: what the robot has seen closes all ways there, or it has long looked for one in
/// a room.
enum class LeftOut { Late, NoWayFound };

/// Follows a coverage plan. A lane is entered at its start, or where it was interrupted, and is divided into goals at
/// most `goal_distance_m` apart, so that giving up a goal loses only that piece. Works in the map frame.
class Survey {
public:
    Survey() = default;
    explicit Survey(mapping::CoveragePlan plan, bool routed = false, double lane_spacing_m = 9.0)
        : plan_(std::move(plan))
        , lane_spacing_m_(lane_spacing_m)
        , routed_(routed)
        , counts_(plan_.lanes.size(), true) {}
    /// Plans lanes over the area of the task, starting near its start pose (see planSurvey). Returns an error if none
    /// fit into the area.
    static Result<Survey> make(const agent::Task& task, const Settings& settings);

    bool done() const { return lane_ >= plan_.lanes.size(); }
    /// Whether the robot flies along the lane; false on its way there.
    bool onLane() const { return on_lane_; }
    /// The lane that is being flown or approached, counting from 0; laneCount() if all are done.
    std::size_t laneIndex() const { return lane_; }
    std::size_t laneCount() const { return plan_.lanes.size(); }
    const mapping::CoveragePlan& plan() const { return plan_; }
    /// Goals that were not reached in time, without those to which no way was found, and the length of the lanes that
    /// was left out with them, as a share of what can be reached of all lanes.
    int goalsGivenUp() const { return goals_given_up_; }
    double givenUp_pct() const {
        const double within_reach_m = plannedLength_m() - cut_off_m_;
        return within_reach_m > 0.0 ? 100.0 * given_up_m_ / within_reach_m : 0.0;
    }
    double cutOff_m() const { return cut_off_m_; } ///< length of the lanes to which no way was found
    /// The share of the planned lanes that was left out for whatever reason, 0 to 1.
    double leftOut() const { return plannedLength_m() > 0.0 ? (given_up_m_ + cut_off_m_) / plannedLength_m() : 0.0; }

    /// The point to reach next: where the lane is entered, or the end of its present piece. The survey must not be
    /// done.
    Vec2 goal_m(const Settings& settings) const { return pointAt_m(on_lane_ ? pieceEnd_m(settings) : entry_along_m_); }
    Vec2 laneEnd_m() const { return pointAt_m(length_m()); } ///< Call it only while lanes are left.
    /// The point to steer at: on the lane ahead of the robot, so that it returns to the lane after a detour. The survey
    /// must not be done.
    Vec2 aim_m(const Vec2& position_m, const Settings& settings) const;

    /// Records how far along the lane the robot has flown. Call it once per tick.
    void note(const Vec2& position_m);
    /// Returns whether the present goal (see goal_m) is reached; false if the survey is done. `in_the_open`: nothing is
    /// in the robot's way, so it flies to the very end of the last lane, which no way to another lane shows.
    bool goalReached(const Vec2& position_m, const Settings& settings, bool in_the_open = false) const;
    /// Moves on to the next goal after the present one was reached.
    SurveyEvent next(const Settings& settings);
    /// Moves on to the next goal because the present one was not reached.
    SurveyEvent giveUp(const Settings& settings, LeftOut why);
    /// Moves on to the farthest point of the present piece to which a way leads, or to where a way leads to the lane,
    /// or to the next lane.
    SurveyEvent cutOff(const Settings& settings, const std::function<bool(const Vec2&)>& can_reach);
    /// Adds lanes that are flown after the others. What of them is left out is no loss for the survey, so it does not
    /// count as given up or cut off.
    void add(const std::vector<mapping::Lane>& lanes);
    int addedLeftOut() const { return added_left_out_; } ///< so many added lanes were not flown to their ends
    /// Adds what was cut off of the lanes once more, because another way was found; it does not count as cut off until
    /// it is again.
    void retryCutOff();
    /// Whether its sorties are planned for the battery; otherwise, it is flown quadrant by quadrant.
    bool routed() const { return routed_; }
    /// Whether the robot flies home before the lane with this index, with so much flown since its last charge: between
    /// two sorties that were planned for the battery, unless it has just been there, and after a quadrant, for its INS,
    /// if a charge is worth its time.
    bool goesHomeBefore(std::size_t lane, double since_charge_m, const Settings& settings) const;
    /// Returns the lanes to fly instead of the added ones that are left, given those that were flown or given up.
    using Choice = std::function<std::vector<mapping::Lane>(const std::vector<mapping::Lane>& flown)>;
    /// Plans the rest of the survey anew, for a robot that stands at its base (see `replanned`). `added` chooses the
    /// added lanes; if it is empty, they are only ordered, and if it returns none, the survey is done. Returns whether
    /// lanes were moved or left out. Nothing changes for a survey by quadrants if the robot is in no hurry or more than
    /// `few_lanes` are left, or while lanes of both kinds are left.
    bool replan(const ScanLedger& ledger, const Vec2& base_m, const Settings& settings, double detour,
                const Choice& added);
    /// Moves the lanes from the next one on (m, map frame), because a robot that leans scans what is beside it. Nothing
    /// changes while the robot is on a lane.
    void shift(const Vec2& by_m) { shift_m_ = on_lane_ ? shift_m_ : by_m; }
    /// Records that the robot leaves the lane (for the battery). The lane will be entered again at this point.
    void interrupt();

    /// The distance from the start of the present lane up to which it is flown or given up. The survey must not be
    /// done.
    double alongLane_m() const { return std::max(entry_along_m_, reached_m_); }
    /// The length of the lanes that is finished, including parts that were given up.
    double doneLength_m() const;
    double totalLength_m() const { return plan_.lane_length_m; }
    /// The same without the lanes that were added.
    double plannedLength_m() const { return plan_.lane_length_m - added_m_; }
    /// The start and end of each lane, in the order of the flight, and the base where it flies home before the next
    /// one.
    std::vector<Vec2> path_m(const Vec2& base_m, const Settings& settings) const;

private:
    struct Place {
        double along_m = 0.0; ///< distance along the lane from its start
        double aside_m = 0.0; ///< distance from the lane, never negative
    };
    Place placeOf(const Vec2& position_m) const;
    double length_m() const;
    Vec2 pointAt_m(double along_m) const;
    double pieceEnd_m(const Settings& settings) const;
    SurveyEvent endPiece(const Settings& settings);
    void append(mapping::Lane lane, bool counts);
    /// Makes what was flown of the present lane a lane of its own, which is done.
    void divideLane();
    /// Notes that the present lane is left out between these distances along it.
    void leaveOut(double from_m, double to_m, LeftOut why);
    SurveyEvent nextLane();

    mapping::CoveragePlan plan_;
    double lane_spacing_m_ = 9.0;
    bool routed_ = false; ///< its sorties are planned for the battery
    std::size_t lane_ = 0;
    double finished_lanes_m_ = 0.0;
    bool on_lane_ = false;
    double entry_along_m_ = 0.0;        ///< entry point; this and the next two are distances along the lane
    double piece_start_m_ = 0.0;        ///< everything before it was flown or given up
    double reached_m_ = 0.0;            ///< farthest point that was flown
    std::optional<double> short_end_m_; ///< end of a piece whose rest is cut off
    int goals_given_up_ = 0;
    Vec2 shift_m_ = Vec2::Zero();
    double given_up_m_ = 0.0;
    double cut_off_m_ = 0.0;
    std::vector<bool> counts_; ///< by lane: what of it is left out counts
    std::vector<mapping::Lane> cut_off_;
    double added_m_ = 0.0;
    int added_left_out_ = 0;
};

} // namespace usar::airrobot
