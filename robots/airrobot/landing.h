// Where and how to come down, and how to know that one is down.
#pragma once

#include <optional>

#include "robots/airrobot/obstacle_memory.h"
#include "robots/airrobot/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The even place nearest to `wanted_m`, within `radius_m`, as far as the scanner knows the ground; `wanted_m` itself
/// where nothing better is known.
Vec2 landingPlace_m(const ObstacleMemory& memory, const Vec2& wanted_m, double radius_m);

/// Sinks fast, then slowly, and notices the touch: told to sink and not sinking for a second. Owned by one robot.
class Touchdown {
public:
    void start() { still_since_.reset(); }
    double sinkRate_m_s(const Senses& senses, const Settings& settings) const;
    /// Once a tick while sinking.
    bool touched(const Senses& senses);

private:
    std::optional<Seconds> still_since_;
};

} // namespace usar::airrobot
