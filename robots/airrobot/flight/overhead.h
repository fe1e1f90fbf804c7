// Finds out what is above the robot, which has no sensor that looks up: it learns that when it rolls, and when it
// cannot climb.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// Remembers ceilings and how far up the air was seen to be free. Heights are in the map frame of the robot's own
/// estimate. Call `observe` once per tick in the air. Owned by one robot.
class Overhead {
public:
    /// How far a climb ends below a ceiling, from the robot's origin.
    static constexpr double margin_m = 0.8;
    /// A robot whose ring meets a ceiling at this speed or slower does not break: 1 kg at 0.42 m/s is 0.42 N s of the
    /// 0.5 N s that it withstands (robots-and-worlds.md 3.1). A twig in the disc of a rotor breaks it at any speed.
    static constexpr double careful_m_s = 0.42;
    /// The same under way, where a touch is more likely than in a take-off. Some roofs met at the speed above broke it
    /// (`tst_random_surveys_campaign`, numbers 37, 45 and 133).
    static constexpr double gentle_m_s = 0.3;

    /// The part of the last command that matters here.
    struct Doing {
        double climb_m_s = 0.0; ///< commanded in the last tick
        /// True in a take-off. Ceilings are looked for only then, because among trees a crown can look like one.
        bool ascending = false;
    };
    void observe(const Senses& senses, const Doing& doing);

    /// The height up to which a fast climb is safe: a margin below the highest point that a beam has reached. A ceiling
    /// that is wide enough would have met that beam.
    double freeTo_m() const { return free_to_m_ - margin_m; }
    /// The same where trees stand around: no roof is lower, though a crown may be.
    double seenTo_m() const { return seen_to_m_ - margin_m; }
    /// True if there is a ceiling anywhere. Then there may be more of them.
    bool hasCeiling() const { return !ceilings_.empty() || lid_m_; }
    /// True if there was one at any time, even before the position estimate has jumped: the robot may be in a building.
    bool everHadCeiling() const { return had_ceiling_; }
    /// Has the robot stay below this height (map z) everywhere as if a ceiling were there, so that it flies under what
    /// stands in its way higher up; nullopt: no more.
    void putLid(std::optional<double> lid_m) {
        lid_m_ = lid_m;
        lid_floor_m_ = floor_m();
    }
    /// True if a wall has stood beside the robot for a while, up to its height or higher. It may carry a roof.
    bool besideWall(Seconds now) const { return walled_at_ && now - *walled_at_ < wall_memory; }
    /// The lowest ceiling near a place; nullopt if none is known. The estimate of the height drifts: where the floor
    /// seems to be lower than when a ceiling was found, so is the ceiling.
    std::optional<double> ceiling_m(const Vec2& at_m) const;
    /// The greatest height to fly at there; infinite if no ceiling is known.
    double limit_m(const Vec2& at_m) const;
    /// The climb rate for a wanted one: at most this one, and none at a ceiling.
    double allowed_m_s(const Senses& senses, double climb_m_s, double at_most_m_s) const;
    /// The ceiling that was found in this tick, and how; nullopt in most ticks.
    struct Find {
        double z_m = 0.0;
        bool touched = false; ///< The ring has touched it; otherwise the scanner has seen it.
        bool anew = true;     ///< No ceiling of that height was known anywhere.
    };
    const std::optional<Find>& found() const { return found_; }

    /// Takes the ceilings above the height `z_m` (map z) for small ones, such as a floor on posts, which end not far
    /// from where they were found, or for great ones again. Those that the robot is above are small in any case.
    void takeForSmall(bool small, double z_m) {
        for (Ceiling& one : ceilings_)
            one.reach_m = small || z_m > one.z_m ? small_reach_m : great_reach_m;
    }
    /// The distance of the nearest place at which a ceiling was found; `otherwise_m` if there is none so near.
    double nearestFind_m(const Vec2& at_m, double otherwise_m) const;
    /// Forgets the ceilings that were touched and not seen: a robot that obeys late seems to be held up by something.
    void forgetTouches() {
        std::erase_if(ceilings_, [](const Ceiling& one) { return one.touched; });
    }
    /// Forgets everything, because the position estimate has jumped.
    void forgetPlaces() {
        const bool had_ceiling = had_ceiling_;
        *this = {};
        had_ceiling_ = had_ceiling;
    }

private:
    struct Ceiling {
        Vec2 at_m = Vec2::Zero();
        double z_m = 0.0;
        bool touched = false; ///< not seen
        double reach_m = great_reach_m;
        Seconds found_at{0.0}; ///< the last time
        double floor_m = unknown_floor_m;
    };

    static constexpr double great_reach_m = 60.0; ///< A ceiling is taken to reach this far,
    static constexpr double small_reach_m = 2.0;  ///< or so far if it is a small one.
    static constexpr Seconds wall_memory{10.0};
    static constexpr Seconds touch_memory{6.0};
    static constexpr double unknown_floor_m = 1e9;

    /// One scan seemed to show a ceiling at this height.
    struct Glimpse {
        double z_m = 0.0;
        Seconds time{0.0};
    };

    void lookUp(const PlacedScan& scan, Seconds now, bool ascending);
    /// Forgets the ceilings below `past_m` (map z), because beams of two scans have passed that height. One that the
    /// robot has just touched is kept as a small one.
    void lookPast(double past_m, Seconds now);
    void lookBeside(const PlacedScan& scan, Seconds now);
    void feelAbove(const Senses& senses, double commanded_climb_m_s);
    void lookDown(const Senses& senses);
    /// The lowest ground (map z) below the robot in the last 15 to 30 s.
    double floor_m() const { return std::min(floor_now_m_, floor_before_m_); }
    double drifted_m(double z_m, double floor_then_m) const;
    void add(const Ceiling& ceiling);

    std::vector<Ceiling> ceilings_;
    bool had_ceiling_ = false;
    std::optional<double> lid_m_;
    double lid_floor_m_ = unknown_floor_m;
    double floor_now_m_ = unknown_floor_m;    ///< since `floor_since_`
    double floor_before_m_ = unknown_floor_m; ///< for a while before
    Seconds floor_since_{0.0};
    std::optional<Find> found_;
    std::optional<Glimpse> glimpse_;
    std::optional<Seconds> pushing_since_; ///< a climb is commanded since then
    double pushed_from_m_ = 0.0;           ///< height at that time
    double pushed_m_s_ = 0.0;              ///< the rate at which a free robot would climb by now
    double pushed_m_ = 0.0;                ///< how far it would have come since then
    Seconds felt_at_{0.0};                 ///< time of the last tick
    double free_to_m_ = -1e9;              ///< map z
    double seen_to_m_ = -1e9;              ///< map z
    double highest_near_m_ = -1e9;         ///< PlacedScan::highest_near_m of the last scan
    int walls_ = 0;                        ///< scans in a row with a wall in them
    std::optional<Seconds> walled_at_;     ///< time of the last of so many that it was no trunk
};

} // namespace usar::airrobot
