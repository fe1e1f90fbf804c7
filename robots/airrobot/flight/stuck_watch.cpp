#include "robots/airrobot/flight/stuck_watch.h"

namespace usar::airrobot {

namespace {
constexpr double same_goal_m = 0.5;
constexpr double progress_m = 1.0;
} // namespace

void StuckWatch::reset() {
    goal_m_.reset();
    best_m_ = 0.0;
    now_ = progress_at_ = hindered_ = Seconds(0.0);
}

void StuckWatch::wait(Seconds now) {
    if (!goal_m_)
        return;
    progress_at_ += now - now_;
    now_ = now;
}

void StuckWatch::update(Seconds now, const Vec2& position_m, const Vec2& goal_m, bool hindered) {
    const double distance_m = (goal_m - position_m).norm();
    const Seconds step = goal_m_ ? now - now_ : Seconds(0.0);
    now_ = now;
    if (!goal_m_ || (*goal_m_ - goal_m).norm() > same_goal_m || distance_m < best_m_ - progress_m) {
        goal_m_ = goal_m;
        best_m_ = distance_m;
        progress_at_ = now;
        hindered_ = Seconds(0.0);
        return;
    }
    if (hindered)
        hindered_ += step;
}

} // namespace usar::airrobot
