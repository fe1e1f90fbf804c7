// How long the stages of a task really take, against what the speeds in the parameters promise; and the forecast of the
// rest that follows from it.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/agent/published.h"

namespace usar::agent {

/// An expected amount (usually seconds) and its variance. Forecasts of independent stages add up.
struct Forecast {
    double mean = 0.0;
    double variance = 0.0; ///< in the square of the unit

    Forecast& operator+=(const Forecast& other) {
        mean += other.mean;
        variance += other.variance;
        return *this;
    }
    double deviation() const { return std::sqrt(variance); }
    /// The range that holds four of five normally distributed values: mean - 1.28 s to mean + 1.28 s, where s² is the
    /// variance; never below 0.
    TimeRange range() const {
        constexpr double four_of_five = 1.28;
        const double margin = four_of_five * deviation();
        return {Seconds(std::max(0.0, mean - margin)), Seconds(std::max(0.0, mean + margin))};
    }
};

/// Learns from the stages of one kind that are over: lanes, ways, charges. For stages i = 1 … n that were planned to
/// take p(i) and took t(i), with a prior of pace r0, which counts as a planned amount of w, and of scatter v0, which
/// counts as m stages:
///
///     pace      r = (r0 w + Σ t) / (w + Σ p)
///     scatter   v = (v0 m + Σ (t - r p)² / p) / (m + n)
///
/// A rest that is planned to take P then takes r P, with the variance v P + v P² / (w + Σ p): the scatter of the rest
/// itself, and that of the pace, which was measured on so little only. Plain data with no clock of its own.
class Pace {
public:
    struct Prior {
        double pace = 1.0;    ///< r0
        double weight = 1.0;  ///< w, in the unit of the amounts; positive
        double scatter = 1.0; ///< v0, in the unit of the amounts
        double stages = 3.0;  ///< m
    };
    explicit Pace(const Prior& prior) : prior_(prior) {}

    /// A stage is over. Does nothing unless `planned` is positive.
    void note(double planned, double took) {
        if (!(planned > 0.0))
            return;
        planned_ += planned;
        took_ += took;
        squares_ += took * took / planned;
        stages_ += 1.0;
    }
    double pace() const { return (prior_.pace * prior_.weight + took_) / weight(); }
    double scatter() const {
        const double r = pace();
        const double measured = std::max(0.0, squares_ - 2.0 * r * took_ + r * r * planned_);
        return (prior_.scatter * prior_.stages + measured) / (prior_.stages + stages_);
    }
    Forecast forecast(double planned) const {
        return {pace() * planned, scatter() * planned * (1.0 + planned / weight())};
    }

private:
    double weight() const { return prior_.weight + planned_; }

    Prior prior_;
    double planned_ = 0.0;
    double took_ = 0.0;
    double squares_ = 0.0; ///< sum of t² / p
    double stages_ = 0.0;
};

} // namespace usar::agent
