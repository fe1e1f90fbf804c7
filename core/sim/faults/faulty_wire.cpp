#include "core/sim/faults/faulty_wire.h"

#include <algorithm>

namespace usar::sim {

namespace {

constexpr Seconds hair{1e-6}; // Tolerance, because ticks are sums of doubles.

bool isClock(std::string_view line) {
    return line.starts_with("STA ") || line.starts_with("NFO {Lockstep");
}

} // namespace

void FaultyWire::setFaults(const std::vector<Fault>& active) {
    delay_ = Seconds{0.0};
    double kept = 1.0;
    holds_ = false;
    for (const Fault& fault : active) {
        if (fault.kind == FaultKind::LinkDelay)
            delay_ += Seconds{fault.number("by")};
        else if (fault.kind == FaultKind::LinkLoss)
            kept *= 1.0 - fault.number("share");
        holds_ |= fault.kind == FaultKind::LinkHalfOpen;
    }
    loss_ = 1.0 - kept;
}

void FaultyWire::push(std::string lines, Seconds now, bool lockstep, bool is_tick) {
    if (lines.empty())
        return;
    std::string bytes;
    if (loss_ == 0.0)
        bytes = std::move(lines);
    for (std::string_view rest = lines; loss_ > 0.0 && !rest.empty();) {
        const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
        rest.remove_prefix(line.size());
        bytes += lockstep && isClock(line) ? std::string(line) : damaged(line);
        if (lockstep && !bytes.ends_with('\n'))
            bytes += "\r\n"; // Otherwise the clock's line would be glued to this one.
    }
    const Seconds earliest = outward_.empty() ? now : outward_.back().due;
    waiting_bytes_ += bytes.size();
    outward_.push_back({std::move(bytes), std::max(now + delay_, earliest), is_tick});
}

FaultyWire::Arrived FaultyWire::take(Seconds now) {
    Arrived arrived;
    while (!holds_ && !outward_.empty() && outward_.front().due <= now + hair) {
        arrived.bytes += outward_.front().bytes;
        waiting_bytes_ -= outward_.front().bytes.size();
        arrived.ticks += outward_.front().is_tick ? 1 : 0;
        outward_.pop_front();
    }
    return arrived;
}

std::string FaultyWire::garbled(std::string_view line) {
    const bool clock = line.starts_with("STEP") || line.starts_with("LOCKSTEP");
    return loss_ == 0.0 || clock ? std::string(line) : damaged(line);
}

std::vector<protocol::Command> FaultyWire::takeCommands(Seconds now) {
    std::vector<protocol::Command> arrived;
    while (!holds_ && !inward_.empty() && inward_.front().due <= now + hair) {
        arrived.push_back(std::move(inward_.front().command));
        inward_.pop_front();
    }
    return arrived;
}

std::string FaultyWire::damaged(std::string_view bytes) {
    std::string left;
    for (const char byte : bytes)
        if (uniform(random_, 0.0, 1.0) >= loss_)
            left += byte;
    return left;
}

} // namespace usar::sim
