// Finds a place to land, controls the descent and detects the ground.
#pragma once

#include <optional>
#include <span>

#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// Older tops are not those of this estimate: it has drifted meanwhile, by a decimeter or two in this time. The brink
/// of a slope was hidden by them (`quick_scan`, seed 55).
inline constexpr Seconds newest_tops{30.0};

/// Returns a nearby even place within `radius_m` of `wanted_m` (map frame) where the scanner has just seen the
/// ground; `wanted_m` itself if it is even enough or no better place is known. `lean` is the slope, upward along the
/// map's axes, of the ground on which the robot would stand upright: one that leans against the wind as it comes down
/// must not meet ground that rises toward its low side. Only what was seen within `fresh` counts.
Vec2 landingPlace_m(const ObstacleMemory& memory, const Vec2& wanted_m, double radius_m,
                    const Vec2& lean = Vec2::Zero(), Seconds fresh = newest_tops);

/// How far a robot that sinks must stay from all that is known to stand beside it. Usual: what was seen since the
/// memory began counts, and a berth for drift and gusts. Least: what its last scans showed, and little more than its
/// own width; a single scan that was placed wrong, minutes ago, may have closed all places to it (`quick_scan`, seed
/// 73).
enum class Room { Usual, Least };

/// With the least room, older sights do not count. It hovers for less than that before it takes another place.
inline constexpr Seconds lately{20.0};

/// Where to land in need. Owned by one robot; its places belong to one estimate of the pose, so make a new one after
/// the INS was set.
class Refuge {
public:
    /// Remembers the place of the robot if it could land there. Ground lower than `dry_m` (map z) may be the bed of
    /// water, which the scanner looks through. Call it once per tick in the air.
    void note(const Senses& senses, const ObstacleMemory& memory, double dry_m);
    /// The nearest place in sight where the robot could land and to which nothing stands in the way, or else the
    /// nearest one, or the last one that it flew over; nullopt if there is none. It is well away from all `refused_m`,
    /// and no narrow thing's top unless there is nothing else, because a crown is as even. A steep place is taken only
    /// if there is no gentler one within 6 m beyond it.
    std::optional<Vec2> place_m(const Senses& senses, const ObstacleMemory& memory, double dry_m,
                                std::span<const Vec2> refused_m = {}, Room room = Room::Usual) const;

private:
    std::optional<Seconds> noted_; ///< time of the last look at the ground
    std::optional<Vec2> last_m_;
};

/// True if the scanner has seen the ground there, and it is even, wide enough to stand on, and not lower than `dry_m`.
bool canLand(const ObstacleMemory& memory, const Vec2& place_m, double dry_m);

enum class Descent {
    UnderWay,
    Landed,
    KeptAway, ///< it does not get over its place, or cannot stand there
};

/// Sinks over the chosen place only, fast at first and slowly near the ground. The robot has landed if it was commanded
/// to sink and has not sunk for about a second, or for some seconds if its scanner has a bias. Owned by one robot.
class Touchdown {
public:
    void start(Room room = Room::Usual) {
        *this = {};
        room_ = room;
    }
    /// Makes the robot sink where it is, whatever stands below, as soon as its own battery lasts for nothing else: it
    /// would fall otherwise. Call it once per tick of a landing.
    void mindBattery(const Senses& senses, const Settings& settings);
    bool sinksAnyway() const { return sinks_anyway_; }
    /// Returns whether the robot is over its place, so that it may sink. Call it once per tick of a landing.
    bool isOver(const Senses& senses, const Vec2& place_m);
    /// Where to land: `place_m`, or where the ground turned out to be better as it looked at it from low above.
    Vec2 placeFor_m(const Vec2& place_m) const { return better_m_.value_or(place_m); }
    /// Returns whether the robot shall turn around as it sinks the last meters, so that its scanner sees all of the
    /// ground below it. Once it has turned, it lands on the best ground that it saw, at `place_m` if that is even.
    /// Call it once per tick over the place.
    bool looksAround(const Senses& senses, const ObstacleMemory& memory, const Vec2& place_m, const Vec2& lean);
    /// Whether it may sink further on its way to its place: nothing that stands there, or that it may meet beside it,
    /// is known to reach up to it. Crowns count, and so do walls; the ground of the place does not.
    static bool isClearBelow(const Senses& senses, const ObstacleMemory& memory, const Vec2& place_m,
                             Room room = Room::Usual);
    /// True also where it stands over its place already, whatever is remembered of the height of that: the drift may
    /// have made it deeper.
    bool maySink(const Senses& senses, const ObstacleMemory& memory, const Vec2& place_m) const {
        const bool stands = over_ && senses.heightOverGround_m(1e9) < stands_m;
        return sinks_anyway_ || stands || isClearBelow(senses, memory, place_m, room_);
    }
    /// True if the scanner sees again and again that the robot cannot stand on what is below its ring: the drift of the
    /// pose has moved a place that was fit. Call it once per tick over the place.
    bool isUneven(const Senses& senses);
    /// True if it has held its height (`holds`), because it is not over its place, for so long that something must be
    /// in its way. Call it once per tick of a landing.
    bool keptAway(const Senses& senses, bool holds);
    /// Returns the rate of descent, positive downward.
    double sinkRate_m_s(const Senses& senses, const Settings& settings) const;
    /// Returns whether the robot has landed. Call it once per tick while sinking.
    bool touched(const Senses& senses);

private:
    static constexpr double stands_m = 0.5; ///< between its base and the ground, at most

    std::optional<Seconds> still_since_;
    std::optional<Seconds> held_since_; ///< it holds its height since then
    Room room_ = Room::Usual;
    bool over_ = false;
    bool sinks_anyway_ = false; ///< at `better_m_`
    int uneven_scans_ = 0;      ///< in a row
    double turned_rad_ = 0.0;
    std::optional<double> last_yaw_rad_;
    std::optional<Seconds> turning_since_;
    std::optional<Vec2> better_m_;
};

} // namespace usar::airrobot
