#include "core/mission/drive_gate.h"

#include <utility>

namespace usar::mission {

namespace {

void keep(std::optional<double>& term, const std::optional<double>& old) {
    if (!term)
        term = old;
}

void keepAbsentTerms(protocol::AerialDrive& newer, const protocol::AerialDrive& older) {
    keep(newer.climb_m_s, older.climb_m_s);
    keep(newer.forward_m_s, older.forward_m_s);
    keep(newer.left_m_s, older.left_m_s);
    keep(newer.yaw_rate_rad_s, older.yaw_rate_rad_s);
}

void keepAbsentTerms(protocol::SkidDrive& newer, const protocol::SkidDrive& older) {
    keep(newer.left_rad_s, older.left_rad_s);
    keep(newer.right_rad_s, older.right_rad_s);
}

/// Where both are of this kind and unit.
template <class Drive>
void merge(protocol::Command& newer, const protocol::Command& older) {
    auto* to = std::get_if<Drive>(&newer);
    const auto* from = std::get_if<Drive>(&older);
    if (to && from && to->normalized == from->normalized)
        keepAbsentTerms(*to, *from);
}

} // namespace

bool DriveGate::isDrive(const protocol::Command& command) {
    return std::holds_alternative<protocol::AerialDrive>(command) ||
           std::holds_alternative<protocol::SkidDrive>(command);
}

void DriveGate::offer(agent::CausedCommand drive) {
    if (held_) {
        merge<protocol::AerialDrive>(drive.command, held_->command);
        merge<protocol::SkidDrive>(drive.command, held_->command);
    }
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
