#include "robots/airrobot/flight/link_watch.h"

#include <algorithm>
#include <utility>

#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

namespace {

constexpr Seconds step = 0.75 * usual_tick; ///< Entries are not closer than this, because UDK's ticks are shorter.
constexpr Seconds gap{0.6};                 ///< After a longer silence, the watch begins anew.
constexpr std::size_t window = 25;          ///< entries that are compared
constexpr std::size_t longest_delay = 20;   ///< entries
constexpr Seconds estimate_every{1.0};
/// A velocity that is told 0.2 s long makes so much of the robot's; its autopilot and inertia take the rest of the
/// time.
constexpr double obeyed_share = 0.35;
/// A robot whose link is not late obeys after so many entries.
constexpr std::size_t usual_delay = 1;
constexpr std::size_t least_late = 3; ///< entries more than usual; a take-off can look as if it were 2
constexpr double least_motion = 0.12; ///< root of the mean square, m/s and rad/s
constexpr double well_explained = 0.35;
constexpr double better_by = 0.15; ///< than with the usual delay
constexpr double as_good = 0.05;   ///< Where a motion repeats itself, the shortest of several delays counts.

/// A robot that stands leaves the ground so long after it was told to, and less than a tick more.
constexpr Seconds usual_lift_off{0.8};
constexpr Seconds surely_late{0.5};
constexpr double lifts_m_s = 0.15;

Eigen::Vector4d valuesOf(const LinkWatch::Motion& motion) {
    return {motion.velocity_m_s.x(), motion.velocity_m_s.y(), motion.velocity_m_s.z(), motion.yaw_rate_rad_s};
}

} // namespace

void LinkWatch::note(Seconds now, const Motion& commanded, const Motion& measured, bool free) {
    if (!free)
        noteLiftOff(now, commanded.velocity_m_s.z(), measured.velocity_m_s.z());
    if (!entries_.empty() && (now < entries_.back().at || now - entries_.back().at > gap)) {
        entries_.clear();
        candidate_.reset();
        estimated_ = now;
    }
    if (!entries_.empty() && now - entries_.back().at < step)
        return;
    Values smooth = valuesOf(commanded);
    if (!entries_.empty())
        smooth = entries_.back().commanded + obeyed_share * (smooth - entries_.back().commanded);
    entries_.push_back({now, smooth, valuesOf(measured), free});
    if (entries_.size() > window + longest_delay)
        entries_.pop_front();
    if (now - estimated_ >= estimate_every) {
        estimated_ = now;
        estimate();
    }
}

void LinkWatch::noteLiftOff(Seconds now, double commanded_climb_m_s, double climb_m_s) {
    if (commanded_climb_m_s < lifts_m_s) {
        told_to_lift_.reset();
        return;
    }
    if (!told_to_lift_)
        told_to_lift_ = climb_m_s < lifts_m_s ? std::optional(now) : std::nullopt;
    if (!told_to_lift_ || climb_m_s < lifts_m_s)
        return;
    const Seconds late = now - *told_to_lift_ - usual_lift_off;
    if (late >= surely_late)
        late_ = late;
    told_to_lift_ = Seconds{1e9}; // It is in the air, and is not asked again.
}

std::optional<double> LinkWatch::unexplained(std::size_t delay) const {
    if (entries_.size() < window + delay)
        return std::nullopt;
    const std::size_t first = entries_.size() - window;
    Values mean_measured = Values::Zero();
    Values mean_commanded = Values::Zero();
    for (std::size_t i = first; i < entries_.size(); ++i) {
        if (!entries_[i].free || !entries_[i - delay].free)
            return std::nullopt;
        mean_measured += entries_[i].measured / window;
        mean_commanded += entries_[i - delay].commanded / window;
    }
    double rest = 0.0;
    double motion = 0.0;
    // The means are taken out, because a steady motion may come from the wind.
    for (std::size_t i = first; i < entries_.size(); ++i) {
        const Values moved = entries_[i].measured - mean_measured;
        rest += (moved - (entries_[i - delay].commanded - mean_commanded)).squaredNorm();
        motion += moved.squaredNorm();
    }
    return motion < window * least_motion * least_motion ? std::nullopt : std::optional(rest / motion);
}

void LinkWatch::estimate() {
    const auto usually = unexplained(usual_delay);
    if (!usually)
        return;
    std::size_t best = usual_delay;
    double best_rest = *usually;
    for (std::size_t delay = 0; delay <= longest_delay; ++delay)
        if (const auto rest = unexplained(delay); rest && *rest < best_rest - as_good) {
            best = delay;
            best_rest = *rest;
        }
    if (best_rest > well_explained)
        return;
    const bool is_late = best >= usual_delay + least_late && best_rest < *usually - better_by;
    const std::size_t found = is_late ? best : usual_delay;
    const auto before = std::exchange(candidate_, found);
    if (before && std::max(*before, found) - std::min(*before, found) <= 1)
        late_ = static_cast<double>(found - usual_delay) * usual_tick;
}

} // namespace usar::airrobot
