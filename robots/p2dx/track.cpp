#include "robots/p2dx/track.h"

#include <algorithm>
#include <cmath>

namespace usar::p2dx {

namespace {

constexpr std::size_t longest_way = 50; ///< number of steps
constexpr Seconds longest_memory{600.0};
constexpr double straight_rad = 0.3;
constexpr double slope_over_m = 0.4;
constexpr double least_slope_m = 0.25;
constexpr double least_course_m = 0.03;
constexpr double sideways_rad = 0.6; ///< a larger error is not drift of the yaw; the robot slips sideways
constexpr double course_weight = 0.05;

} // namespace

void Track::update(Seconds now, const Pose& ins_in_map, Motion motion) {
    const Vec3 step_m = begun_ ? Vec3(ins_in_map.position_m - position_m_) : Vec3(Vec3::Zero());
    last_turn_rad_ = begun_ ? normalizedAngle(ins_in_map.yaw_rad - ins_yaw_rad_) : 0.0;
    begun_ = true;
    position_m_ = ins_in_map.position_m;
    ins_yaw_rad_ = ins_in_map.yaw_rad;
    last_step_m_ = step_m.head<2>().norm();
    distance_m_ += last_step_m_;
    yaw_rad_ = normalizedAngle(ins_yaw_rad_ + correction_rad_);
    if (motion == Motion::Straight)
        correctYaw(step_m);
    if (motion == Motion::Straight || motion == Motion::Curve) {
        way_.push_back({position_m_, yaw_rad_});
        if (way_.size() > longest_way)
            way_.pop_front();
    }
    places_.push_back({now, position_m_.head<2>()});
    while (now - places_.front().at > longest_memory)
        places_.pop_front();
}

void Track::correctYaw(const Vec3& step_m) {
    if (last_step_m_ < least_course_m)
        return;
    const double error_rad = normalizedAngle(std::atan2(step_m.y(), step_m.x()) - yaw_rad_);
    if (std::abs(error_rad) < sideways_rad)
        correction_rad_ = normalizedAngle(correction_rad_ + course_weight * error_rad);
}

double Track::wayBehind_m() const {
    double way_m = 0.0;
    for (std::size_t i = way_.size(); i > 1; --i) {
        if (std::abs(normalizedAngle(way_[i - 2].yaw_rad - yaw_rad_)) > straight_rad)
            break;
        way_m += (way_[i - 1].position_m - way_[i - 2].position_m).head<2>().norm();
    }
    return way_m;
}

double Track::descent_rad() const {
    double run_m = 0.0;
    double fall_m = 0.0;
    for (std::size_t i = way_.size(); i > 1 && run_m < slope_over_m; --i) {
        const Vec3 step_m = way_[i - 1].position_m - way_[i - 2].position_m;
        run_m += step_m.head<2>().norm();
        fall_m -= step_m.z();
    }
    return run_m < least_slope_m ? 0.0 : std::atan2(fall_m, run_m);
}

double Track::progress_m(Seconds during) const {
    if (places_.empty() || places_.back().at - places_.front().at < during)
        return unknown_m;
    double farthest_m = 0.0;
    for (auto place = places_.rbegin(); place != places_.rend() && places_.back().at - place->at <= during; ++place)
        farthest_m = std::max(farthest_m, (place->position_m - places_.back().position_m).norm());
    return farthest_m;
}

} // namespace usar::p2dx
