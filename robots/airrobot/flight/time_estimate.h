// Estimate of the time that a survey still needs: lanes, ways, landings and charges of the plan at the paces measured
// so far.
#pragma once

#include <optional>

#include "core/agent/pace.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// The kinds of stages of which a mission consists, besides the time before the first take-off.
enum class Stage {
    None,
    Lane,    ///< along a lane
    Way,     ///< to a lane, with the turn, or home
    Landing, ///< from over the base until the robot rests
    Charge   ///< from then on until it is at work again
};

/// Where the robot is in its mission, besides its lanes. Places are in the map frame.
struct MissionState {
    Vec2 position_m = Vec2::Zero();
    Vec2 base_m = Vec2::Zero();
    double since_charge_m = 0.0; ///< distance flown since the last charge
    Seconds waiting{0.0};        ///< time until it flies on: for the rest of a landing, charge or take-off
    bool lanes_left = true;      ///< the lanes that are not done will be flown
    bool returning = false;      ///< it is in the air on its way to the base, to land there
    double added_m = 0.0;        ///< length of the lanes that will probably be added
};

/// A whole mission, flown in thought.
struct WholeFlight {
    agent::Forecast time; ///< in seconds
    double charges = 0.0; ///< the mean
};

/// What has passed up to a tick.
struct MissionMoment {
    Seconds now{0.0};
    Stage stage = Stage::None; ///< since the last tick
    bool returning = false;    ///< the way is that home
    bool holding = false;      ///< the robot waits for a person or for its sensors, which teaches nothing
    Vec2 position_m = Vec2::Zero();
    double done_m = 0.0;  ///< Survey::doneLength_m
    double flown_m = 0.0; ///< BatteryModel::flown_m
};

/// Learns how much longer each kind of stage takes than the parameters' speeds promise, mostly because of evasion, and
/// flies the rest of the mission in thought. Before anything was measured, the priors speak. Owned by one robot.
class TimeEstimate {
public:
    /// Call it once per tick.
    void note(const MissionMoment& moment, const Settings& settings);
    /// Time in seconds until the robot has landed at its base for good, if nothing stops it, with its variance: the
    /// rest of each kind of stage by its Pace. How many charges are still needed depends on how much longer the way
    /// flown is than the plan's, d with deviation s. So the mean m and the variance are those of three flights in
    /// thought, at d - √2 s, d and d + √2 s with the shares of ¼, ½ and ¼: Σ share (variance(i) + (mean(i) - m)²).
    agent::Forecast forecast(const Survey& survey, const MissionState& state, const Settings& settings) const {
        return rest(survey, state, settings).time;
    }
    /// The whole mission of a robot that still stands at its base, with the stages' paces so far. `added_m`: length of
    /// the lanes that will probably be added.
    WholeFlight whole(const Survey& survey, const Vec2& base_m, double added_m, const Settings& settings) const;
    /// Estimates when the mission ends, at most once a second, because a long survey has many lanes.
    void update(Seconds now, const Survey& survey, const MissionState& state, const Settings& settings);
    /// True if the mission has taken so much longer than was expected at its start that it will hardly come to an end.
    /// Time on purpose (see MissionMoment::holding) does not count.
    bool overdue() const;
    /// Time in seconds until the end by the last estimate; nullopt before the first.
    std::optional<agent::Forecast> left(Seconds now) const;
    /// The pace of a kind of stage, which must not be None.
    const agent::Pace& pace(Stage stage) const { return paces_[static_cast<std::size_t>(stage) - 1]; }
    /// The way that is flown for each meter of the lanes.
    double detour() const { return detour_.pace(); }

private:
    WholeFlight rest(const Survey& survey, const MissionState& state, const Settings& settings) const;
    WholeFlight flightInThought(double detour, const Survey& survey, const MissionState& state,
                                const Settings& settings) const;
    agent::Pace& paceOf(Stage stage) { return paces_[static_cast<std::size_t>(stage) - 1]; }
    void noteLane(const MissionMoment& moment, Seconds passed, const Settings& settings);
    void noteStage(const Settings& settings);
    /// What the part of the present stage that is over was planned to take.
    double plannedStage_s(const Settings& settings) const;
    /// `pace`, with the part of the present stage that is over: a robot that has been held up for a minute is late now.
    agent::Pace paceSoFar(Stage stage, const Settings& settings) const;

    static constexpr std::size_t kinds = 4;
    /// The priors lie between open ground, where lanes take 1.03 times as long, and woods, where they take up to 1.5
    /// times as long; landings are faster high up than at the end.
    agent::Pace paces_[kinds] = {agent::Pace({1.13, 400.0, 4.0, 3.0}), agent::Pace({1.0, 200.0, 1.5, 3.0}),
                                 agent::Pace({0.85, 60.0, 0.5, 3.0}), agent::Pace({0.9, 200.0, 0.2, 3.0})};
    agent::Pace detour_{{1.06, 300.0, 0.3, 3.0}}; ///< meters flown against meters of the plan

    /// What was flown of lanes since the last note.
    struct Piece {
        Seconds took{0.0};
        double planned_m = 0.0;
        double flown_m = 0.0;
    };

    std::optional<MissionMoment> last_;
    Seconds took_{0.0};          ///< in the present stage
    Vec2 from_m_ = Vec2::Zero(); ///< where the present stage began
    Piece piece_;
    Seconds spent_{0.0};               ///< since the first take-off
    std::optional<Seconds> expected_;  ///< time of the whole mission by the first estimate
    std::optional<Seconds> estimated_; ///< time of the last estimate
    agent::Forecast forecast_;         ///< its result
};

} // namespace usar::airrobot
