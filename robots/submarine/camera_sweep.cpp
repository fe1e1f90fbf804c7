#include "robots/submarine/camera_sweep.h"

#include <algorithm>
#include <cmath>

namespace usar::submarine {

namespace {

constexpr Seconds between_commands{0.5};
constexpr double tilts_a_pan = 3.0;
constexpr double widest_pan_rad = 2.0; ///< limit of the pan to each side for a mount that can turn farther
constexpr double share_of_speed = 0.8;

/// A triangle wave: 0 at whole numbers, 1 halfway between them.
double toAndFro(double phase) {
    const double part = phase - std::floor(phase);
    return 1.0 - std::abs(2.0 * part - 1.0);
}

struct Span {
    double from = 0.0;
    double to = 0.0;
    double at(double share) const { return std::lerp(from, to, share); }
};

Span spanOf(const protocol::LinkConfiguration& link) {
    return {std::max(link.smallest.value_or(-widest_pan_rad), -widest_pan_rad),
            std::min(link.largest.value_or(widest_pan_rad), widest_pan_rad)};
}

/// Returns `half`, extended so that no link has to move faster than it can.
Seconds slowEnough(Seconds half, const protocol::PackageConfiguration& mount) {
    for (std::size_t i = 0; i < std::min<std::size_t>(2, mount.links.size()); ++i) {
        const Span span = spanOf(mount.links[i]);
        const double speed = share_of_speed * mount.links[i].speed_limit.value_or(1.0);
        if (speed > 0.0)
            half = std::max(half, Seconds((span.to - span.from) / speed * (i == 0 ? 1.0 : tilts_a_pan)));
    }
    return half;
}

} // namespace

std::optional<protocol::Command> CameraSweep::next(Seconds now, Seconds half, const Limits& limits) {
    if (!last_)
        last_ = now;
    if (now - *last_ < between_commands)
        return std::nullopt;
    if (limits.mount)
        half = slowEnough(half, *limits.mount);
    phase_ += (now - *last_) / half / 2.0;
    last_ = now;
    turn_ = 1 - turn_;
    if (turn_ == 1)
        return limits.mount ? move(*limits.mount) : std::nullopt;
    return limits.camera ? zoom(*limits.camera) : std::nullopt;
}

std::optional<protocol::Command> CameraSweep::move(const protocol::PackageConfiguration& mount) const {
    const auto name = protocol::Token::make(mount.name);
    if (!name || mount.links.empty())
        return std::nullopt;
    protocol::PackageDrive drive{*name};
    drive.links.push_back({mount.links[0].link, spanOf(mount.links[0]).at(toAndFro(phase_))});
    if (mount.links.size() > 1)
        drive.links.push_back({mount.links[1].link, spanOf(mount.links[1]).at(toAndFro(tilts_a_pan * phase_))});
    return drive;
}

std::optional<protocol::Command> CameraSweep::zoom(const protocol::CameraConfiguration& camera) const {
    if (!camera.smallest_fov_rad || !camera.largest_fov_rad)
        return std::nullopt;
    const Span angles{*camera.smallest_fov_rad, *camera.largest_fov_rad};
    return protocol::ZoomCamera{angles.at(toAndFro(tilts_a_pan * phase_)), protocol::Name::mended(camera.name)};
}

} // namespace usar::submarine
