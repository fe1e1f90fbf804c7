// Small classes that count and measure what befalls a robot, one step at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/sim/robots/robot_figures.h"

namespace usar::sim {

/// Counts collisions: touches that follow one another closely are one.
class CollisionCounter {
public:
    /// Touches no more than this apart are one collision.
    static constexpr Seconds apart{0.5};

    /// Lets time pass, to be called at each step.
    void pass(Seconds dt) {
        now_ += dt;
        since_ += dt;
    }
    /// Takes a touch, several times per step if need be.
    void touch() {
        count_ += since_ > apart ? 1 : 0;
        since_ = Seconds{0.0};
        first_ = first_.value_or(now_);
    }
    int count() const { return count_; }
    /// Time of the first touch, counted from the counter's beginning; nullopt before it.
    std::optional<Seconds> first() const { return first_; }

private:
    Seconds now_{0.0};
    Seconds since_{1e9};
    int count_ = 0;
    std::optional<Seconds> first_;
};

/// The longest time that something stayed in one place, be it a robot that is trapped or one that waits. A new stay
/// begins when the position is more than a meter from where the last one began.
class StayWatch {
public:
    static constexpr double place_radius_m = 1.0;

    explicit StayWatch(const Vec3& position_m) : place_m_(position_m) {}

    /// Takes the position after another `dt`.
    void step(Seconds dt, const Vec3& position_m) {
        stay_ += dt;
        if ((position_m - place_m_).norm() > place_radius_m) {
            place_m_ = position_m;
            stay_ = Seconds{0.0};
        }
        longest_ = std::max(longest_, stay_);
    }
    Seconds longest() const { return longest_; }

private:
    Vec3 place_m_;
    Seconds stay_{0.0};
    Seconds longest_{0.0};
};

/// Counts how often a robot fell over. A fall is a lean of more than 60 degrees; the next one counts only after the
/// robot has stood upright again.
class FallWatch {
public:
    /// `up_z` is the z component of the base's z axis in the map frame.
    void step(double up_z) {
        if (!lies_ && up_z < lying_z) {
            lies_ = true;
            ++count_;
        } else if (lies_ && up_z > upright_z) {
            lies_ = false;
        }
    }
    int count() const { return count_; }

private:
    static constexpr double lying_z = 0.5;    ///< cosine of 60 degrees
    static constexpr double upright_z = 0.85; ///< cosine of 32 degrees

    bool lies_ = false;
    int count_ = 0;
};

/// Collects heights, one per tick.
class HeightWatch {
public:
    void step(double height_m) {
        least_m_ = count_ == 0 ? height_m : std::min(least_m_, height_m);
        ++count_;
        const double off_m = height_m - mean_m_;
        mean_m_ += off_m / count_;
        squares_m2_ += off_m * (height_m - mean_m_);
    }
    /// Returns nullopt before the first height.
    std::optional<HeightFigures> figures() const {
        if (count_ == 0)
            return std::nullopt;
        return HeightFigures{least_m_, mean_m_, std::sqrt(squares_m2_ / count_)};
    }

private:
    double least_m_ = 0.0;
    double mean_m_ = 0.0;
    double squares_m2_ = 0.0; ///< sum of squared distances from the mean
    double count_ = 0.0;
};

/// Remembers where a robot was when it collided.
class CollisionPlaces {
public:
    /// A robot that is stuck collides thousands of times; the first places tell what happened.
    static constexpr std::size_t most = 20;

    /// `collisions` is the number so far.
    void step(int collisions, const Vec3& position_m) {
        if (collisions > counted_ && places_m_.size() < most)
            places_m_.push_back(position_m);
        counted_ = collisions;
    }
    const std::vector<Vec3>& places_m() const { return places_m_; }

private:
    int counted_ = 0;
    std::vector<Vec3> places_m_;
};

} // namespace usar::sim
