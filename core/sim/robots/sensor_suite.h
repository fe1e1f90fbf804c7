// The sensors of one robot: measured in the order of a tick, queried and set by type and name.
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

/// Initial conditions of a robot and its sensors.
struct RobotOptions {
    Pose base_in_map;
    std::uint64_t seed = 1;
    std::uint64_t number = 0;              ///< number of the spawn: each robot has random streams of its own
    std::optional<Seconds> battery_life{}; ///< replaces the model's
    Seconds scan_interval{0.2};            ///< the message tick
    bool noise = true;
    protocol::Dialect profile = protocol::Dialect::Ut2004;
};

/// Every sensor has a random stream of its own, so sensors and robots added later change nobody's noise. With the
/// setting `every`, a sensor measures only at each n-th tick. UT2004's sensors measure at each tick, UDK's at intervals
/// of their own (protocol.md 1.8).
class SensorSuite {
public:
    /// Fails for a sensor that cannot be built. `robot` must outlive the suite.
    static Result<SensorSuite> make(const RobotModel& robot, const RobotOptions& options);

    /// Measures one tick. The `first` one of UT2004 brings only sensors that need no history. UDK's sensors have
    /// timers, which ring for the first time when an interval has passed (protocol.md 2.4).
    void measure(const SensorView& view, bool first, std::vector<protocol::InfoMessage>& out);
    /// The cameras with their current poses.
    std::vector<SeenFrom> cameras(const RobotBody& body) const;
    /// The items of this type, all or the named one, in any case. If there are none, the bare head.
    protocol::GeometryInfo geometry(const std::string& type, const std::string& name) const;
    protocol::ConfigurationInfo configuration(const std::string& type, const std::string& name) const;
    /// Passes a SET to the sensors it is meant for. Returns the first answer, or a later one that reports a failure;
    /// nullopt if there is no such sensor or none knows the command.
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest);

    /// Sets the faults that act on sensors, until the next call. The sensors' own noise continues as it would without
    /// them.
    void setFaults(const std::vector<Fault>& active);
    /// True if there is a sensor with this type or name, in any case.
    bool has(std::string_view type_or_name) const;

private:
    /// Sensors of this type, all or the named one, in any case.
    std::vector<const Sensor*> find(const std::string& type, const std::string& name) const;

    struct Place {
        std::unique_ptr<Sensor> sensor;
        std::uint64_t every = 1; ///< measures at each n-th tick
        std::vector<Fault> faults{};
        std::vector<protocol::InfoMessage> frozen{}; ///< the lines it repeats while it is frozen
        std::uint64_t chance_stream = 0;
        std::optional<Random> chance{}; ///< decides which readings drop out; exists since the first such fault
    };
    bool isDue(const Place& place, bool first) const;
    /// Measures as without faults, then alters the lines or leaves them out.
    void measureFaulty(Place& place, const SensorView& view, std::vector<protocol::InfoMessage>& out);
    std::vector<Place> sensors_;
    std::uint64_t seed_ = 1;
    std::uint64_t ticks_ = 0;
    protocol::Dialect profile_ = protocol::Dialect::Ut2004;
};

} // namespace usar::sim
