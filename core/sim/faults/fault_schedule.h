// The faults of a run: what is to come, what acts now, and what is over.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/sim/faults/fault.h"
#include "core/sim/faults/wind.h"

namespace usar::sim {

enum class FaultPhase { ToCome, Active, Over };

/// For lists and logs.
struct FaultStatus {
    int id = 0;
    Fault fault;
    FaultPhase phase = FaultPhase::ToCome;
    bool operator==(const FaultStatus&) const = default;
};

/// "fault begins: wind speed=5".
std::string sentenceOf(const FaultStatus& turned);

/// Time is an argument: the same faults at the same ticks do the same. Owned by a Simulation.
class FaultSchedule {
public:
    explicit FaultSchedule(std::uint64_t seed) : seed_(seed) {}

    /// The number that `end` takes.
    int add(const Fault& fault);
    /// At the next `advance`; false where there is no such fault or it is over.
    bool end(int id);

    /// Those that have begun or ended since the last call.
    std::vector<FaultStatus> advance(Seconds now);
    /// What acts on this robot.
    std::vector<Fault> activeOn(std::string_view robot_name) const;
    /// A cut happens once, as soon as there is somebody to cut off: true, and the cut is over.
    bool takeCut(std::string_view robot_name);
    /// The air's velocity for the next `dt`, map frame.
    Vec3 wind(Seconds dt);

    const std::vector<FaultStatus>& all() const { return faults_; }

private:
    struct Blowing {
        int id = 0;
        Wind wind;
    };

    std::uint64_t seed_;
    std::vector<FaultStatus> faults_;
    std::vector<int> ending_;
    std::vector<Blowing> winds_;
};

} // namespace usar::sim
