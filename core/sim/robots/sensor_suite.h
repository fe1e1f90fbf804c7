// The sensors of one robot: measured in a tick's order, asked and set by type and name.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/dialect.h"
#include "core/sim/camera/camera_scene.h"
#include "core/sim/faults/fault.h"
#include "core/sim/sensors/sensor.h"

namespace usar::sim {

struct SuiteBirth {
    Pose base_in_map;
    std::uint64_t seed = 1;
    std::uint64_t robot_number = 0;
    Seconds scan_interval{0.2};
    bool noise = true;
    protocol::Dialect profile = protocol::Dialect::Ut2004;
};

/// Every sensor has a random stream of its own: sensors and robots that come later change nobody's noise. The setting
/// `every` of a sensor makes it measure at each n-th tick only. UT2004's measure at each tick, UDK's at intervals of
/// their own (usarsim-protocol 1.8).
class SensorSuite {
public:
    /// `robot` must outlive it. Fails for a sensor that cannot be built.
    static Result<SensorSuite> make(const RobotModel& robot, const SuiteBirth& birth);

    /// One tick; on the `first` only what needs no history.
    void measure(const SensorView& view, bool first, std::vector<protocol::InfoMessage>& out);
    /// As they stand on this robot now.
    std::vector<SeenFrom> cameras(const RobotBody& body) const;
    /// Items of this type, all or the named one, in any case; the bare head when there is none.
    protocol::GeometryInfo geometry(const std::string& type, const std::string& name) const;
    protocol::ConfigurationInfo configuration(const std::string& type, const std::string& name) const;
    /// The first answer of the sensors that the command is meant for; nothing when there is none, or none knows it.
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest);

    /// Those that act on sensors, until the next call. The sensors' own noise goes on as without them.
    void setFaults(const std::vector<Fault>& active);
    bool has(std::string_view type_or_name) const;

private:
    std::vector<const Sensor*> find(const std::string& type, const std::string& name) const;

    struct Place {
        std::unique_ptr<Sensor> sensor;
        std::uint64_t every = 1; ///< ticks
        std::vector<Fault> faults{};
        std::vector<protocol::InfoMessage> frozen{}; ///< what it repeats, while it does
        std::uint64_t chance_stream = 0;
        std::optional<Random> chance{}; ///< of the readings that do not come, since the first such fault
    };
    void measureFaulty(Place& place, const SensorView& view, std::vector<protocol::InfoMessage>& out);
    std::vector<Place> sensors_;
    std::uint64_t seed_ = 1;
    std::uint64_t ticks_ = 0;
    protocol::Dialect profile_ = protocol::Dialect::Ut2004;
};

} // namespace usar::sim
