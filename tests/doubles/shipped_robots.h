// The robots that come with the program, from the build's own share folder.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "core/sim/robots/robot_reader.h"

namespace usar::doubles {

/// Read once. Test and benchmark programs lie in build/<preset>/tests and build/<preset>/bin.
inline std::shared_ptr<const sim::RobotCatalog> shippedRobots() {
    static const auto robots = [] {
        const auto program = std::filesystem::read_symlink("/proc/self/exe");
        sim::RobotsRead read = sim::readRobots(program.parent_path() / "../share/robots");
        if (!read.refused.empty())
            throw std::runtime_error(read.refused.front().text());
        return std::make_shared<const sim::RobotCatalog>(std::move(read.robots));
    }();
    return robots;
}

} // namespace usar::doubles
