// Commands about the simulation itself.
#pragma once

#include "core/base/clock.h"

namespace usar::protocol {

/// LOCKSTEP: makes our own server wait for a STEP before each tick, or ends this (simulator.md, "Faster than real
/// time"). A real server silently ignores both commands. The answer is LockstepInfo.
struct Lockstep {
    bool on = true;
    bool operator==(const Lockstep&) const = default;
};
/// STEP: allows the next tick in lockstep.
struct Step {
    bool operator==(const Step&) const = default;
};

/// TEST, known from a single client; no server is known to react to it.
struct Test {
    bool operator==(const Test&) const = default;
};
/// PAUSE, likewise known from a single client only.
struct Pause {
    Seconds time{0.0};
    bool operator==(const Pause&) const = default;
};

} // namespace usar::protocol
