// Smoothing of stick input: a limited rise.
#pragma once

#include "core/base/clock.h"
#include "core/base/stick.h"

namespace usar::mission {

/// Follows a stick: away from 0 by at most a full share per `rise`, toward 0 and through it at once. So a release stops
/// the robot, whatever came before. It has no clock of its own.
class StickShaper {
public:
    static constexpr Seconds rise{0.4};

    /// Returns the shaped position; `dt` is the time since the last call, which also limits the first one after a
    /// reset.
    Stick follow(const Stick& asked, Seconds dt);
    const Stick& now() const { return now_; }
    void reset() { now_ = {}; }

private:
    Stick now_;
};

} // namespace usar::mission
