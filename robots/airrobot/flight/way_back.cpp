#include "robots/airrobot/flight/way_back.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

constexpr double step_m = 0.5; ///< between the places of the trail
constexpr std::size_t longest = 200;
constexpr double trail_passed_m = 0.4;
/// With something nearer than this on all sides, or below it, the robot goes nowhere.
constexpr double closed_m = 0.75;
constexpr double gets_on_m = 0.7;
constexpr Seconds pinned_for{6.0};
constexpr Seconds standing_for{20.0};
constexpr Seconds in_vain{20.0};

} // namespace

void WayBack::note(Seconds now, const Vec2& here_m, double nearest_m) {
    if (trail_.empty() || (here_m - moved_to_m_).norm() > gets_on_m) {
        moved_to_m_ = here_m;
        moved_at_ = now;
    }
    now_ = now;
    here_m_ = here_m;
    nearest_m_ = nearest_m;
    if (active_) {
        while (!trail_.empty() && (trail_.back() - here_m).norm() < trail_passed_m)
            trail_.pop_back();
        const bool has_room = nearest_m >= room_m_ && (here_m - began_at_m_).norm() >= least_m_;
        active_ = !trail_.empty() && !has_room && now - moved_at_ < in_vain;
    }
    if (active_ || (!trail_.empty() && (trail_.back() - here_m).norm() < step_m))
        return;
    const auto again =
        std::ranges::find_if(trail_, [&](const Vec2& place_m) { return (place_m - here_m).norm() < step_m; });
    trail_.erase(again, trail_.end());
    trail_.push_back(here_m);
    if (trail_.size() > longest)
        trail_.erase(trail_.begin());
}

bool WayBack::isPinned() const {
    return nearest_m_ < closed_m && now_ - moved_at_ > pinned_for;
}

bool WayBack::stands() const {
    return now_ - moved_at_ > standing_for;
}

bool WayBack::begin(double room_m, double least_m) {
    while (!trail_.empty() && (trail_.back() - here_m_).norm() < trail_passed_m)
        trail_.pop_back();
    active_ = !trail_.empty();
    moved_at_ = now_;
    room_m_ = room_m;
    least_m_ = least_m;
    began_at_m_ = here_m_;
    return active_;
}

} // namespace usar::airrobot
