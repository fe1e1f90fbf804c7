#include "tests/doubles/simulated_flight.h"

#include "core/protocol/command_writer.h"

namespace usar::test {

SimulatedFlight::SimulatedFlight(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<agent::Behavior> behavior,
                                 const Pose& start_in_map, const protocol::Token& robot_class)
    : simulation_(std::move(simulation))
    , client_(simulation_->connect())
    , host_(std::move(behavior), "simulated") {
    const protocol::Init init{robot_class, "R1", start_in_map};
    simulation_->receive(client_, protocol::write(init) + "\r\n");
}

void SimulatedFlight::run(Seconds limit, const std::function<void()>& each) {
    while (!host_.finished() && simulation_->now() < limit && !truth().broken) {
        simulation_->step();
        const std::string bytes = simulation_->takeOutput(client_);
        splitter_.feed(bytes, [this](std::string_view line) { take(line); });
        if (each)
            each();
    }
}

void SimulatedFlight::take(std::string_view text) {
    if (listener_)
        listener_(true, text);
    const protocol::InfoLine line = reader_.read(text);
    if (std::holds_alternative<protocol::RangeScan>(line.message))
        scan_ = line;
    const agent::BehaviorHost::Output output = host_.receive(line);
    for (const agent::CausedCommand& caused : output.commands) {
        const std::string command = protocol::write(caused.command);
        if (listener_)
            listener_(false, command);
        simulation_->receive(client_, command + "\r\n");
    }
    for (const agent::Published& value : output.published)
        keep(value);
}

void SimulatedFlight::keep(const agent::Published& value) {
    if (const auto* status = std::get_if<agent::BehaviorStatus>(&value))
        status_ = *status;
    if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value))
        ending_ = *finished;
    if (const auto* event = std::get_if<agent::BehaviorEvent>(&value))
        events_.push_back(event->text);
    const auto* placement = std::get_if<agent::ScanPlacement>(&value);
    if (!placement || placement->scan_line != scan_.number)
        return;
    const auto& scan = std::get<protocol::RangeScan>(scan_.message);
    const mapping::Beams beams{scan.ranges_m, scan.resolution_rad, scan.fov_rad, 20.0};
    integrator_.integrate(beams, placement->scanner_in_map, placement->scan_line, map_);
}

sim::RobotTruth SimulatedFlight::truth() const {
    const auto robots = simulation_->robots();
    return robots.empty() ? sim::RobotTruth{} : robots.front();
}

double SimulatedFlight::coverage_pct(const Rectangle& area_in_map) const {
    std::size_t known = 0;
    std::size_t total = 0;
    const double half_m = map_.cellSize_m() / 2.0;
    for (double y_m = area_in_map.min_m.y() + half_m; y_m < area_in_map.max_m.y(); y_m += map_.cellSize_m()) {
        for (double x_m = area_in_map.min_m.x() + half_m; x_m < area_in_map.max_m.x(); x_m += map_.cellSize_m()) {
            ++total;
            known += map_.height_m(map_.cellAt({x_m, y_m})) ? 1 : 0;
        }
    }
    return total == 0 ? 0.0 : 100.0 * static_cast<double>(known) / static_cast<double>(total);
}

} // namespace usar::test
