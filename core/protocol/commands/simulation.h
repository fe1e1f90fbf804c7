// Commands about the simulation itself.
#pragma once

#include "core/base/clock.h"
#include "core/protocol/commands/description.h"

namespace usar::protocol {

/// LOCKSTEP: makes our own server wait for a STEP before each tick, or ends this (simulator.md, "Faster than real
/// time"). A real server silently ignores both commands. The answer is LockstepInfo.
struct Lockstep {
    bool on = true;
    bool operator==(const Lockstep&) const = default;

    static constexpr CommandWord word{"LOCKSTEP", "our server only: time stands still until STEP",
                                      "LOCKSTEP {On true}"};
    static void segments(auto& io, auto& lockstep) {
        io.neededFlag({"On", "whether the server waits for STEP"}, lockstep.on);
    }
};
/// STEP: allows the next tick in lockstep.
struct Step {
    bool operator==(const Step&) const = default;

    static constexpr CommandWord word{"STEP", "our server only: the next tick may come", "STEP"};
    static void segments(auto&, auto&) {}
};

/// TEST, known from a single client; no server is known to react to it.
struct Test {
    bool operator==(const Test&) const = default;

    static constexpr CommandWord word{"TEST", "does nothing", "TEST"};
    static void segments(auto&, auto&) {}
};
/// PAUSE, likewise known from a single client only.
struct Pause {
    Seconds time{0.0};
    bool operator==(const Pause&) const = default;

    static constexpr CommandWord word{"PAUSE", "known from one client only", "PAUSE {Time 10}"};
    static void segments(auto& io, auto& pause) { io.number({"Time", "seconds"}, pause.time); }
};

} // namespace usar::protocol
