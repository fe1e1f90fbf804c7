// The AirRobot's equipment as the thesis flew it, and what GETGEO and GETCONF say of it.
#pragma once

#include <string>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info_message.h"
#include "core/sim/sensors/ground_truth.h"
#include "core/sim/sensors/ins.h"
#include "core/sim/sensors/range_scanner.h"
#include "core/sim/sensors/sonar.h"

namespace usar::sim {

struct AirRobotSensorOptions {
    Pose spawn_in_map;
    std::uint64_t seed = 1;
    std::uint64_t robot_number = 0;
    Seconds scan_interval{0.2};
    bool noise = true;
};

/// L4 … R4 on the ring, `Scanner1` under the belly (centre beam straight down, fan across track), `INS`, `GroundTruth`.
/// Every sensor has a random stream of its own: sensors and robots that come later change nobody's noise.
class AirRobotSensors {
public:
    explicit AirRobotSensors(const AirRobotSensorOptions& options);

    /// One tick: Sonar, RangeScanner, INS, GroundTruth; on the first only the last.
    void measure(const Pose& base_in_map, Seconds now, bool first, const Rays& rays,
                 std::vector<protocol::InfoMessage>& out);
    /// Items of this type, all or the named one, in any case; the bare head when there is none.
    protocol::GeometryInfo geometry(const std::string& type, const std::string& name) const;
    protocol::ConfigurationInfo configuration(const std::string& type, const std::string& name) const;
    bool setIns(const protocol::SetInsPose& wanted, bool at_rest);

private:
    /// One item's row in GEO and CONF.
    struct Item {
        std::string type;
        protocol::MountedItem mounted;
        std::vector<protocol::Setting> settings;
    };
    void describe(Seconds scan_interval);
    std::vector<const Item*> find(const std::string& type, const std::string& name) const;

    std::vector<Sonar> sonars_;
    RangeScanner scanner_;
    Ins ins_;
    GroundTruth ground_truth_;
    std::vector<Item> items_;
};

} // namespace usar::sim
