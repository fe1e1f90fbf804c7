// One fault for a survey that nobody chose.
#pragma once

#include <cstdint>
#include <string>

#include "core/sim/faults/fault.h"

namespace usar::test {

struct RandomFault {
    sim::Fault fault{};
    /// The robot has what it needs to stay in the air and to come home: lift, and power for some minutes. Its sensors
    /// or its link may be gone.
    bool can_fly = true;

    std::string text() const;
};

/// Draws a kind, a time, a duration and a strength. Equal numbers give equal faults. `wind_in_map_m_s` blows already. A
/// link that is cut and a robot that vanishes are not drawn, because a behavior hears nothing after them; the mission
/// runner ends such a mission.
RandomFault drawFault(std::uint64_t number, const Vec2& wind_in_map_m_s);

} // namespace usar::test
