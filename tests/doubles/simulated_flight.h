// A behavior flown in the real simulation, in one process and without sockets: bytes out, bytes in, as fast as it goes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/agent/behavior_host.h"
#include "core/mapping/height_map.h"
#include "core/mapping/scan_integrator.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "core/sim/simulation.h"

namespace usar::test {

/// Owns simulation, connection, behavior and the map that comes of it.
class SimulatedFlight {
public:
    SimulatedFlight(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<agent::Behavior> behavior,
                    const Pose& start_in_map, const protocol::Token& robot_class = "USARBot.AirRobot");

    /// Until the behavior finishes, the robot breaks, or the protocol clock shows `limit`.
    /// `each` is called after every tick.
    void run(Seconds limit, const std::function<void()>& each = {});

    /// Shows every line of the conversation, without its end: true if the robot sent it, false if the behavior did.
    using Listener = std::function<void(bool from_robot, std::string_view line)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    const std::optional<agent::BehaviorFinished>& ending() const { return ending_; }
    const agent::BehaviorStatus& status() const { return status_; }
    /// What it told the person, oldest first.
    const std::vector<std::string>& events() const { return events_; }
    const mapping::HeightMap& map() const { return map_; }
    sim::RobotTruth truth() const;
    /// Part of the area's cells that the map knows, in per cent.
    double coverage_pct(const Rectangle& area_in_map) const;

private:
    void take(std::string_view text);
    void keep(const agent::Published& value);

    std::unique_ptr<sim::Simulation> simulation_;
    sim::ClientId client_;
    agent::BehaviorHost host_;
    protocol::LineSplitter splitter_;
    protocol::Reader reader_;
    protocol::InfoLine scan_;
    mapping::HeightMap map_{0.25};
    mapping::ScanIntegrator integrator_;
    std::optional<agent::BehaviorFinished> ending_;
    agent::BehaviorStatus status_;
    std::vector<std::string> events_;
    Listener listener_;
};

} // namespace usar::test
