// The connection between the server and one client, degraded by faults: late, lossy or half open.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/base/random.h"
#include "core/protocol/command.h"
#include "core/sim/faults/fault.h"

namespace usar::sim {

/// Time moves in message ticks, so a delay is rounded up to whole ticks. The order never changes. If a client is in
/// lockstep, its STA and STEP are never damaged, because they are the clock of both sides, but they may come late.
/// Owned by the client's session.
class FaultyWire {
public:
    /// `random` decides which bytes are lost.
    explicit FaultyWire(Random random) : random_(random) {}

    /// Replaces the faults that act from now on. What is already on its way keeps its time of arrival.
    void setFaults(const std::vector<Fault>& active);

    /// Sends what the server has written. `is_tick` marks the lines of a tick; all else are answers between two ticks.
    void push(std::string lines, Seconds now, bool lockstep, bool is_tick);
    /// The bytes that have reached the client by now; `ticks` counts the ticks whose lines are among them.
    struct Arrived {
        std::string bytes;
        int ticks = 0;
    };
    Arrived take(Seconds now);

    /// A line from the client as the server receives it.
    std::string garbled(std::string_view line);
    /// Sends a command from the client, which arrives after the delay.
    void push(protocol::Command command, Seconds now) { inward_.push_back({std::move(command), now + delay_}); }
    /// Takes the commands that have arrived by now.
    std::vector<protocol::Command> takeCommands(Seconds now);
    /// True if more waits than the buffers of a network hold: 8 MiB of lines, or 65,536 commands.
    bool overfull() const { return waiting_bytes_ > (8u << 20) || inward_.size() > (1u << 16); }

private:
    struct Lines {
        std::string bytes;
        Seconds due;
        bool is_tick = false;
    };
    struct Waiting {
        protocol::Command command;
        Seconds due;
    };

    std::string damaged(std::string_view bytes);

    Random random_;
    Seconds delay_{0.0};
    double loss_ = 0.0;
    bool holds_ = false; ///< half open: nothing comes through
    std::deque<Lines> outward_;
    std::size_t waiting_bytes_ = 0;
    std::deque<Waiting> inward_;
};

} // namespace usar::sim
