// The maps of ways at the height of the flight and near the ground, and flights through doors by the second one.
#pragma once

#include <optional>

#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/overhead.h"
#include "robots/airrobot/flight/pilot.h"
#include "robots/airrobot/flight/route_map.h"

namespace usar::airrobot {

/// A robot that flies below a ceiling may be higher than the doors. While it does, a second map keeps what its scanner
/// sees near the ground. Under a lid the robot stays so low that it gets through doors, takes its ways from that map,
/// and goes nearer to things, but slowly. Owned by one robot; clear it when the INS was set.
class Ways {
public:
    /// Greatest speed where it goes nearer; it bears a touch. At 0.53 and 0.63 m/s, beams broke it (random surveys
    /// 169229 and 169733).
    static constexpr double door_m_s = Overhead::careful_m_s;
    static constexpr double door_half_width_m = 0.9; ///< of the free way that it needs there

    /// Forgets all places; `base_z_m` is the height of the robot on the ground (map z).
    void startAnew(double base_z_m);
    /// Forgets the ways at the present height.
    void clear() { map().clear(); }
    /// The map for the present height.
    RouteMap& map() { return under_ ? low_ : high_; }
    const RouteMap& map() const { return under_ ? low_ : high_; }
    /// Adds what the sensors see in this tick below the ceiling `below_m` (map z). `sure`: it flies so high that its
    /// sonars do not hear the ground. `roofed`: there is a ceiling somewhere.
    void take(const Senses& senses, double below_m, bool sure, bool roofed);

    /// All places to which ways lead from here at this height.
    ReachablePlaces reach(const Senses& senses, Width width) const {
        return map().reach(senses.position2_m(), senses.position_m().z(), width);
    }
    /// Ground to which a way leads from there near the ground, as through a door, but none higher up, where the robot
    /// reaches these places.
    std::optional<Vec2> groundBehindDoor_m(const Vec2& from_m, const ReachablePlaces& higher_up) const;
    /// Where to sink for the way from there to this ground: as near to its end as the robot gets higher up, over open
    /// ground with nothing beside it. nullopt if there is no such place.
    std::optional<Vec2> placeToSink_m(const Vec2& from_m, const Vec2& ground_m, const ReachablePlaces& higher_up,
                                      const ObstacleMemory& memory) const;

    /// Puts a lid over the robot, under which it has to sink at this place, or takes it away.
    void goUnder(const Vec2& place_m, Overhead& overhead);
    void comeUp(Overhead& overhead);
    /// Has it sink farther away from what it has touched as it sank under the lid.
    void touch(const Senses& senses, const Vec2& touched_m);
    /// The motion by which it sinks under the lid; nullopt where it need not.
    std::optional<Motion> sink(const Senses& senses) const;
    /// Has it go nearer to things from now on or no more; under a lid it does anyway.
    void comeNear(bool near) { near_ = near; }
    /// The same for as long as its detour leads through a narrow place.
    void squeeze(bool narrow) { squeezes_ = narrow; }
    /// The same where it does not get on: what its sonars hear around it keeps it there, although there may be room.
    /// Call it in each tick in which the robot is to fly somewhere.
    void noteProgress(Seconds now, const Vec2& here_m);
    bool isUnder() const { return under_; }
    bool isNarrow() const { return near_ || under_ || squeezes_ || hesitates_; }
    /// The settings with which threats are judged: in a door of 3 m, every sonar to the side would hear a high risk.
    Settings forThreats(Settings settings) const;

private:
    RouteMap high_;
    RouteMap low_;
    double lid_m_ = 1e9; ///< map z
    bool under_ = false;
    bool sunk_ = false; ///< since then
    bool near_ = false;
    bool squeezes_ = false;
    bool hesitates_ = false;
    Vec2 moved_to_m_ = Vec2::Zero(); ///< where it was when it moved last, or began to hesitate
    Seconds moved_at_{0.0};
    Seconds asked_at_{-1e9};
    Vec2 sink_at_m_ = Vec2::Zero();
};

} // namespace usar::airrobot
