// Reads robot files (SDFormat 1.9, described in resources/robots/README.md) into robot models.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// Fails for what cannot be built, and names the file and the part. A file that has not been written since the last
/// call is not read again. Callable from any thread.
Result<RobotModel> readRobot(const std::filesystem::path& file);

/// Result of reading a folder.
struct RobotsRead {
    RobotCatalog robots;
    std::vector<Error> refused; ///< one error for each file that was left out
};

/// Reads all *.sdf files of a folder in the order of their names. A class name that occurs twice is refused the second
/// time.
RobotsRead readRobots(const std::filesystem::path& folder);

} // namespace usar::sim
