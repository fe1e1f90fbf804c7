// Adds what a survey flies after its lanes: lanes past hidden ground and gaps, and a way through a door.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "robots/airrobot/flight/craft.h"
#include "robots/airrobot/gap_search.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// Adds lanes to a survey, so that a decider needs no act for them. Where lanes were cut off by a wall, and the scanner
/// has seen ground beyond it to which a way leads near the ground, the robot goes before the door, sinks, flies through
/// it, comes up again and tries these lanes once more; on its way home it does the same the other way round. Owned by
/// one behavior.
class Leftovers {
public:
    /// Adds the next lanes over what the others have not shown; returns false if nothing is left that is worth it. Call
    /// it when all lanes are done.
    bool addLanes(Craft& craft, Survey& survey, const ScanLedger& ledger, const Vec2& base_m, agent::CommandPort& port);
    /// Whether lanes are added across the others, past what they have left hidden: under an open sky, where no wall has
    /// cut lanes off.
    static bool crosses(const Craft& craft, const Survey& survey);
    /// Chooses the lanes to fly instead of those across the others that are left, for a robot that stands at its base.
    /// `flown`: the added lanes that were flown or given up, which do not show what they have left hidden; `detour`:
    /// see `replanned`. If there are none, addLanes finds none either.
    std::vector<mapping::Lane> chosenAnew(const Craft& craft, const Survey& survey, const ScanLedger& ledger,
                                          const Vec2& base_m, const std::vector<mapping::Lane>& flown, double detour);
    /// Sinks before the door on the way home. Returns true in the tick in which the robot has come through on its way
    /// out or back and must rise. Call it once per tick in the air.
    bool passDoor(Craft& craft, Survey& survey, bool returning, agent::CommandPort& port);
    /// The place before the door to which it must go first on its way home; nullopt if it has not come through one.
    const std::optional<Vec2>& door_m() const { return door_m_; }
    /// Takes all places to which ways lead when none leads to a goal.
    void noteWall(const ReachablePlaces& reach);
    /// The share of the ground within reach that no scan has shown, when nothing was left to add: GapSearch::missed
    /// where the robot knows it, which it does not after a charge, and under an open sky ScanLedger::hiddenInSeen.
    double missed() const { return missed_; }
    /// The length of the lanes that will probably be added under an open sky: by what the lanes so far have left hidden
    /// between them, and by what is usual as long as they are few. 0 from addLanes on.
    double expected_m(const Craft& craft, const Survey& survey, const ScanLedger& ledger);
    /// Whether the lanes that were planned are done.
    bool begun() const { return begun_; }
    /// Forgets the door, because the robot takes off anew and its map of the walls is empty.
    void startAnew();

private:
    /// Under an open sky: lanes across the others.
    bool crossOnce(const Craft& craft, Survey& survey, const ScanLedger& ledger, const Vec2& base_m,
                   agent::CommandPort& port);
    /// Adds these lanes and says why; false if there are none.
    bool fly(const std::vector<mapping::Lane>& lanes, Survey& survey, const std::string& why, agent::CommandPort& port);
    bool closeGaps(Craft& craft, Survey& survey, const ScanLedger& ledger, agent::CommandPort& port);
    /// Whether the map of ways tells for how much of the area there is a way to it.
    static bool knowsWays(const Craft& craft, const ScanLedger& ledger);
    bool tryDoor(Craft& craft, Survey& survey, const Vec2& base_m, agent::CommandPort& port);

    /// On the way home: comes up where it could fly before it went through the door; true in the tick in which it does.
    bool comeBack(Craft& craft);

    enum class Door { Unknown, ToDoor, Outward, Through, Homeward, Back };

    bool begun_ = false;
    int crossings_ = 0; ///< how often lanes across the others were sought
    GapSearch gaps_;
    int gaps_left_out_ = 0; ///< Survey::addedLeftOut when the search for gaps began
    double missed_ = 0.0;
    std::optional<std::size_t> foretold_at_; ///< Survey::laneIndex for which `expected_m_` was computed
    double expected_m_ = 0.0;
    double added_m_ = 0.0; ///< All lanes that were added are so long together.
    Door state_ = Door::Unknown;
    int tries_ = 0;
    ReachablePlaces reach_;         ///< when no way led to a goal, at the usual height
    bool walled_ = false;           ///< that is known
    Vec2 ground_m_ = Vec2::Zero();  ///< behind the door
    Vec2 sink_at_m_ = Vec2::Zero(); ///< before it
    std::optional<Vec2> door_m_;
};

} // namespace usar::airrobot
