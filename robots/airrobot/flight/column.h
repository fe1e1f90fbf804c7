// Where the robot goes straight up from the ground or down to it, and what it does about crowns beside that way.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robots/airrobot/flight/ascent.h"
#include "robots/airrobot/flight/overhead.h"
#include "robots/airrobot/flight/ring_touch.h"

namespace usar::airrobot {

inline constexpr double look_around_m = 8.0; ///< Things farther away than this do not matter yet.
/// Lower than this, the robot may stand on the ground, or its rotors may still be gathering speed.
inline constexpr double surely_aloft_m = 2.0;
inline constexpr double in_column_m = 0.7; ///< A robot so near to its place goes straight up or down.

/// Crowns hang over places that look free from below, and get wider on the way up. A robot that climbs among them turns
/// around, so that its sonars hear every side in turn, and remembers what they heard. Where something comes too near or
/// is touched, it sinks back and goes on where there is more room. The places are in the map frame. Owned by one robot;
/// a new one for each flight.
class Column {
public:
    /// This is how a climb goes on in this tick.
    struct Minding {
        double at_most_m_s = 1e9; ///< rate of climb; negative: it must sink
        bool turns = false;
    };

    /// `known`: what is known to stand around at this height. `slope` is that of a plane on which the robot would lean
    /// as it usually does now, see Lean. `at_m` may move. Call it once per tick of a climb.
    Minding mind(const Senses& senses, std::span<const Obstacle> known, const Vec2& slope, double commanded_m_s);
    /// True if it found no room above, wherever it tried.
    bool givesUp() const { return tries_ >= most_tries && !sinks_to_m_; }
    /// True if what has ended a climb may end another one here: it has not been passed yet.
    bool mayMeetAgain(const Vec3& here_m) const;
    /// Has it go there, and climb from there on. It gives up where it has failed before.
    void moveTo(const Vec2& place_m, Seconds now);

    std::optional<Vec2> at_m{}; ///< place of the climb if it is not that of the take-off
    Seconds moving_since{0.0};  ///< when that place was chosen
    bool there = false;         ///< the robot is over it
    bool faced = false;         ///< it looks there
    int stops = 0;              ///< on the way there, before something that it did not know
    double top_m = -1e9;        ///< where the straight way down began, map z
    double come_down_m = 0.0;   ///< height that it has lost since then
    /// The places that were chosen after a low ceiling had ended a climb at another one.
    std::vector<Vec2> others_m{};

private:
    static constexpr int most_tries = 4;

    void listen(const Senses& senses);
    /// Whether something flat above comes down into the cones of the sonars, so that what several of them hear comes
    /// nearer fast.
    bool closesIn(const Senses& senses);

    std::vector<Vec3> met_m_;    ///< where sonars heard something, or the ring touched it
    std::vector<Vec3> failed_m_; ///< from where it has sunk back
    RingTouch touch_;
    std::optional<double> sinks_to_m_; ///< map z
    /// Holds what a sonar heard in the last tick, and for how many ticks in a row it has come much nearer.
    struct Closing {
        double range_m = 0.0;
        int ticks = 0;
    };
    std::map<std::string, Closing> closing_; ///< by sonar
    Seconds listened_at_{-1e9};
    int tries_ = 0;
};

inline constexpr double room_to_climb_m = 1.2; ///< around a place to which it goes because of a low ceiling

/// Another place for a climb that a ceiling has ended early: as far as matters from where a ceiling was found, with
/// room around it by what is `near`, and apart from the places that were `tried_m`; `here_m` if there is none.
Vec2 otherColumn_m(std::span<const Obstacle> near, const Vec2& here_m, const Overhead& overhead,
                   std::span<const Vec2> tried_m);

} // namespace usar::airrobot
