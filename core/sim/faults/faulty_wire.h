// The connection between the server and one client, as bad as its faults make it: late, lossy or half open.
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

/// Time moves in message ticks, so a delay is rounded up to them. Nothing changes places. Where a client is in lockstep
/// its STA and STEP are never damaged, for they are the clock of both sides; they may come late. Owned by the client's
/// session.
class FaultyWire {
public:
    explicit FaultyWire(Random random) : random_(random) {}

    void setFaults(const std::vector<Fault>& active);

    /// What the server has written in a tick.
    void push(std::string lines, Seconds now, bool lockstep, bool is_tick);
    /// What has arrived at the client by now; `ticks` counts the ticks whose lines are among it.
    struct Arrived {
        std::string bytes;
        int ticks = 0;
    };
    Arrived take(Seconds now);

    /// A line of the client, as the server gets it.
    std::string garbled(std::string_view line);
    /// A command that the client sent, and those that have arrived by now.
    void push(protocol::Command command, Seconds now) { inward_.push_back({std::move(command), now + delay_}); }
    std::vector<protocol::Command> takeCommands(Seconds now);
    /// More waits than the buffers of a network hold: 8 MiB of lines, or 65,536 commands.
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
    bool holds_ = false;
    std::deque<Lines> outward_;
    std::size_t waiting_bytes_ = 0;
    std::deque<Waiting> inward_;
};

} // namespace usar::sim
