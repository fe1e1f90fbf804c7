// Robot files (SDFormat 1.9, described in resources/robots/README.md) to robot models.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// Refuses what it cannot build, with the file and the name of the part. A file that was not written since is not read
/// again. From any thread.
Result<RobotModel> readRobot(const std::filesystem::path& file);

struct RobotsRead {
    RobotCatalog robots;
    std::vector<Error> refused; ///< one for each file that cannot be read; the others are there all the same
};

/// All *.sdf of a folder, by name of the file; of two with one class name the first.
RobotsRead readRobots(const std::filesystem::path& folder);

} // namespace usar::sim
