#include "robots/airrobot/flight/steering.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace usar::airrobot {

namespace {

constexpr double step_rad = radians(10.0);
constexpr int steps_each_side = 12;
constexpr double change_cost = 0.3;
constexpr double climb_per_metre = 0.5;

std::vector<Obstacle> blocking(std::span<const Obstacle> obstacles, const Vec2& from_m, double level_m) {
    std::vector<Obstacle> kept;
    for (const Obstacle& obstacle : obstacles) {
        const double climbed_m = climb_per_metre * (obstacle.at_m - from_m).norm();
        if (!obstacle.top_known || obstacle.top_m > level_m + climbed_m)
            kept.push_back(obstacle);
    }
    return kept;
}

} // namespace

std::optional<double> Steering::choose(std::span<const Obstacle> obstacles, const Vec2& from_m, const Vec2& goal_m,
                                       double level_m, const WayNeeded& needed) {
    const std::vector<Obstacle> in_the_way = blocking(obstacles, from_m, level_m);
    const Vec2 way_m = goal_m - from_m;
    const double goal_rad = bearingOf(way_m);
    const double length_m = std::min(needed.length_m, way_m.norm() + 0.5);
    std::optional<double> best;
    double best_cost = 0.0;
    for (int step = -steps_each_side; step <= steps_each_side; ++step) {
        const double bearing_rad = normalizedAngle(goal_rad + step * step_rad);
        if (clearance_m(in_the_way, from_m, bearing_rad, needed.half_width_m, length_m) < length_m)
            continue;
        double cost = std::abs(step) * step_rad;
        if (last_rad_)
            cost += change_cost * std::abs(normalizedAngle(bearing_rad - *last_rad_));
        if (!best || cost < best_cost) {
            best = bearing_rad;
            best_cost = cost;
        }
    }
    last_rad_ = best;
    return best;
}

double stoppingSpeed_m_s(double free_m, double braking_m_s2, double latency_s) {
    if (free_m <= 0.0)
        return 0.0;
    const double lost_m_s = braking_m_s2 * latency_s;
    return std::sqrt(lost_m_s * lost_m_s + 2.0 * braking_m_s2 * free_m) - lost_m_s;
}

} // namespace usar::airrobot
