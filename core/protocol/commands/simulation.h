// Commands about the simulation itself.
#pragma once

#include "core/base/clock.h"

namespace usar::protocol {

/// Our own server's words (README, "Faster than real time"); a real server ignores them in silence.
struct Lockstep {
    bool on = true;
    bool operator==(const Lockstep&) const = default;
};
struct Step {
    bool operator==(const Step&) const = default;
};

/// TEST and PAUSE are known from one client each; nobody knows a server that heeds them.
struct Test {
    bool operator==(const Test&) const = default;
};
struct Pause {
    Seconds time{0.0};
    bool operator==(const Pause&) const = default;
};

} // namespace usar::protocol
