// Converts the embedded simulator's figures about a robot to those of a mission's summary.
#pragma once

#include "core/mission/runs/run_summary.h"
#include "core/sim/simulation.h"

namespace usar::app {

/// Copies all figures; the height over ground is absent for a robot that has not dived.
inline mission::TrueFigures trueFiguresOf(const sim::RobotTruth& robot) {
    mission::TrueFigures figures;
    figures.collisions = robot.collisions;
    figures.distance_m = robot.distance_m;
    figures.longest_stay = robot.longest_stay;
    figures.falls = robot.falls;
    figures.touches = robot.touches;
    figures.first_touch = robot.first_touch;
    if (robot.height)
        figures.height = mission::HeightOverGround{robot.height->least_m, robot.height->mean_m, robot.height->spread_m};
    return figures;
}

} // namespace usar::app
