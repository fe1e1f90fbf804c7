// The faults of a run: those to come, those active now, and those that are over.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/random.h"
#include "core/sim/faults/fault.h"

namespace usar::sim {

struct WindParameters {
    Vec3 mean_in_map_m_s = Vec3::Zero(); ///< at 10 m above the ground; points to where it blows
    double gust_m_s = 0.0;               ///< standard deviation along each horizontal axis; half of it vertically
};

/// Gusts are a first-order Gauss-Markov process, the longitudinal form of Dryden's spectrum. Its correlation time is
/// the length scale divided by the mean speed, which counts as at least 3 m/s; MIL-F-8785C (low altitude, 10 m above
/// ground) gives a scale of 68 m.
class Wind {
public:
    /// Starts with random gusts, as if the wind had always blown.
    Wind(const WindParameters& parameters, Random random);

    /// Moves on by `dt` and returns the air's velocity during it, map frame.
    Vec3 step(Seconds dt);

private:
    WindParameters parameters_;
    Random random_;
    Seconds correlation_;
    Vec3 gust_m_s_;
};

/// A fault passes through these phases in this order; one that is ended early may skip Active.
enum class FaultPhase { ToCome, Active, Over };

/// A fault and its state, for lists and logs.
struct FaultStatus {
    int id = 0; ///< the number that `end` takes, from 1
    Fault fault;
    FaultPhase phase = FaultPhase::ToCome;
    bool operator==(const FaultStatus&) const = default;
};

/// A sentence for the log when a fault has begun or ended: "fault begins: wind speed=5".
std::string sentenceOf(const FaultStatus& turned);

/// Time is an argument: the same faults at the same ticks have the same effects. Owned by a Simulation.
class FaultSchedule {
public:
    /// `seed` determines the gusts.
    explicit FaultSchedule(std::uint64_t seed) : seed_(seed) {}

    /// Schedules a fault and returns the number that `end` takes.
    int add(const Fault& fault);
    /// Ends a fault at the next `advance`. Returns false if there is no such fault or it is over.
    bool end(int id);

    /// Brings the schedule to time `now`. Returns the faults that have thereby begun or ended.
    std::vector<FaultStatus> advance(Seconds now);
    /// The active faults that concern this robot.
    std::vector<Fault> activeOn(std::string_view robot_name) const;
    /// True if an active cut concerns this robot. The cut is over at the next `advance`, so it cuts off each robot
    /// once.
    bool takeCut(std::string_view robot_name);
    /// Velocity of the air during the next `dt` at 10 m above the ground (see windShare), map frame: the sum of all
    /// active winds.
    Vec3 wind(Seconds dt);

    /// All faults ever added, in the order of their numbers.
    const std::vector<FaultStatus>& all() const { return faults_; }

private:
    std::uint64_t seed_;
    std::vector<FaultStatus> faults_;
    std::vector<int> ending_;
    std::vector<std::pair<int, Wind>> winds_; ///< those that blow, by the number of their fault
};

} // namespace usar::sim
