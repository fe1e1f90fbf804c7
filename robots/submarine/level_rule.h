// Rules for keeping the height over the bottom, based on the last two values of the belly ray.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "robots/submarine/settings.h"

namespace usar::submarine {

/// The last two readings of the belly ray, in meters; nullopt if there was no bottom within its reach.
struct Echoes {
    std::optional<double> last_m;
    std::optional<double> present_m;
    Seconds apart{0.2}; ///< time between the two

    /// The rate at which the height grows, positive upward; 0 unless there are two readings.
    double climb_m_s() const {
        return last_m && present_m && apart > Seconds{0.0} ? (*present_m - *last_m) / apart.count() : 0.0;
    }
};

/// The required change of height.
enum class Level { Descend, Keep, Ascend };

/// Compares the present height with that in the settings. Without an echo the bottom counts as far below.
Level levelOf(const Echoes& echoes, const Settings& settings);

/// Returns the plane angle by the thesis's one-state rule: above the wanted height the ray must become shorter, below
/// it longer. If it does not, the planes go to their limit; if it does, they stay at `plane_rad`, their present angle.
double plumbPlane_rad(const Echoes& echoes, const Settings& settings, double plane_rad, double plane_limit_rad);

/// Returns the pitch (positive nose up) by our own rule: it takes the robot to its height while the bottom rises at
/// this rate. It is never steeper than the settings allow, so that the ray stays nearly vertical and measures what is
/// below. `heights` are results of `plumb`.
double wantedPitch_rad(const Echoes& heights, double bottom_rise_m_s, double speed_m_s, const Settings& settings);
/// Converts lengths of the ray to heights over the points where it meets the bottom, from the pitch at each reading.
Echoes plumb(Echoes echoes, double last_pitch_rad, double pitch_rad);

/// Returns whether the bottom is too near now, or will be after the time `foresight` if it keeps rising at this rate
/// and the robot stays at its depth. In the thesis, `foresight` is 0.
bool tooNear(const Echoes& heights, double bottom_rise_m_s, Seconds foresight, const Settings& settings);

} // namespace usar::submarine
