// What makes a hand's stick gentle: a dead zone for what never quite rests, and a rise that takes its time.
#pragma once

#include "core/base/clock.h"
#include "core/base/stick.h"

namespace usar::mission {

/// Within `zone` (0..1) it is 0, and from there on it grows to the whole share again, so that nothing jumps. Both axes
/// of one stick are judged together: one that is pushed straight ahead does not lose its slight turn.
void applyDeadZone(double& x, double& y, double zone);

/// Follows a stick: away from 0 no faster than a whole share in `rise`, toward 0 and through it at once. So a release
/// is a stop, whatever came before. No clock of its own.
class StickShaper {
public:
    static constexpr Seconds rise{0.4};

    /// `dt` since the last call; the first one after a reset moves by that much, too.
    Stick follow(const Stick& asked, Seconds dt);
    const Stick& now() const { return now_; }
    void reset() { now_ = {}; }

private:
    Stick now_;
};

} // namespace usar::mission
