// How long nothing may be heard from a robot or a sensor before it counts as silent: for a reading, for a sensor, for a
// robot, and for a robot that a person drives.
#pragma once

#include "core/base/clock.h"

namespace usar::protocol::silence {

/// Protocol clock. An older reading is painted as out of date: it has missed five messages of the slowest server. Views
/// that know the period of a stream also give a slower one three periods.
inline constexpr Seconds reading{1.0};
/// Protocol clock. A sensor that sends nothing for so long is missing: the operator is told, and a behavior's host asks
/// the server whether the sensor exists.
inline constexpr Seconds sensor{3.0};
/// Wall clock. Nothing at all for so long makes everything of the robot out of date. The usual value of
/// SessionLimits::stale; views wait longer if the clock of a slow simulation makes long steps.
inline constexpr Seconds robot{2.0};
/// Wall clock. The same for a robot that a person drives, and shorter, because it must not move unseen: it is stopped
/// then. Four ticks of the server if they take longer.
inline constexpr Seconds driven_robot{1.0};

} // namespace usar::protocol::silence
