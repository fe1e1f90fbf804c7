// What to do about the height over the bottom, by the belly ray's last and present value.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/clock.h"
#include "robots/submarine/pitch_model.h"
#include "robots/submarine/settings.h"

namespace usar::submarine {

/// Two readings of the belly ray, metres; nothing where it found no bottom in its reach.
struct Echoes {
    std::optional<double> last_m;
    std::optional<double> present_m;
    Seconds apart{0.2};

    /// Of the height, by both; 0 where there are not two.
    double climb_m_s() const {
        return last_m && present_m && apart > Seconds{0.0} ? (*present_m - *last_m) / apart.count() : 0.0;
    }
};

enum class Level { Descend, Keep, Ascend };

/// Without an echo the bottom is far below.
Level levelOf(const Echoes& echoes, const Settings& settings);

/// The thesis's one-state regulation: above the height it makes sure that the ray becomes shorter, below that it
/// becomes longer, with all the planes; where it does, they stay as they are. `plane_rad`: where they are now.
double plumbPlane_rad(const Echoes& echoes, const Settings& settings, double plane_rad, double plane_limit_rad);

/// Ours. `heights` are echoes that `plumb` has set upright. The pitch that takes the robot to its height while the
/// bottom rises at this rate, and never steeper than the settings allow: so the ray stays nearly plumb, and what it
/// finds is what lies below.
double wantedPitch_rad(const Echoes& heights, double bottom_rise_m_s, double speed_m_s, const Settings& settings);
/// The height over the bottom where the ray meets it.
Echoes plumb(Echoes echoes, double last_pitch_rad, double pitch_rad);

/// Too near now, or after this time if the bottom rises on as it does and the robot stays as high as it is. `foresight`
/// is 0 in the thesis.
bool tooNear(const Echoes& heights, double bottom_rise_m_s, Seconds foresight, const Settings& settings);

} // namespace usar::submarine
