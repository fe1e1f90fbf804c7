#include "core/mission/drive_gate.h"

#include <utility>

namespace usar::mission {

namespace {

void keepAbsentTerms(protocol::AerialDrive& newer, const protocol::AerialDrive& older) {
    const auto keep = [](auto& term, const auto& old) {
        if (!term)
            term = old;
    };
    keep(newer.climb_m_s, older.climb_m_s);
    keep(newer.forward_m_s, older.forward_m_s);
    keep(newer.left_m_s, older.left_m_s);
    keep(newer.yaw_rate_rad_s, older.yaw_rate_rad_s);
}

} // namespace

bool DriveGate::isDrive(const protocol::Command& command) {
    return std::holds_alternative<protocol::AerialDrive>(command) ||
           std::holds_alternative<protocol::SkidDrive>(command);
}

void DriveGate::offer(agent::CausedCommand drive) {
    auto* newer = std::get_if<protocol::AerialDrive>(&drive.command);
    const auto* older = held_ ? std::get_if<protocol::AerialDrive>(&held_->command) : nullptr;
    if (newer && older && newer->normalized == older->normalized)
        keepAbsentTerms(*newer, *older);
    held_ = std::move(drive);
}

std::optional<agent::CausedCommand> DriveGate::release(Seconds now) {
    // Wire times have two decimals: half a hundredth must not cost a tick.
    constexpr Seconds rounding{0.005};
    if (last_sent_ && now >= *last_sent_ && now - *last_sent_ < spacing - rounding)
        return std::nullopt;
    return releaseNow(now);
}

std::optional<agent::CausedCommand> DriveGate::releaseNow(Seconds now) {
    if (held_)
        last_sent_ = now;
    return std::exchange(held_, std::nullopt);
}

} // namespace usar::mission
