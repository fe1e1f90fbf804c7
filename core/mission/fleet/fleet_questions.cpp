#include "core/mission/fleet/fleet_questions.h"

#include <algorithm>

namespace usar::mission {

namespace {

const Robot* firstOf(const Robots& robots, const auto& fits) {
    const auto found = std::ranges::find_if(robots, fits);
    return found == robots.end() ? nullptr : *found;
}

} // namespace

QStringList liveNames(const Robots& robots) {
    QStringList names;
    for (const Robot* const robot : robots)
        if (!robot->isReplay())
            names << nameOf(*robot);
    return names;
}

bool anyRunning(const Robots& robots) {
    return std::ranges::any_of(robots, &Robot::running);
}

bool anyHalted(const Robots& robots) {
    return std::ranges::any_of(robots, &Robot::standsStill);
}

void orderAll(const Robots& robots, agent::Order order) {
    for (Robot* const robot : robots)
        if (robot->running())
            robot->order(order);
}

void controlHalted(const Robots& robots, agent::PlanStep step) {
    for (Robot* const robot : robots)
        if (robot->standsStill())
            robot->control(step);
}

const Robot* brokenRobot(const Robots& robots, const Robot* first) {
    const auto broke = [](const Robot* robot) { return robot && robot->view().broke && robot->view().figures.spawned; };
    return broke(first) ? first : firstOf(robots, broke);
}

const Robot* robotFor(const Robots& robots, const Robot* first, const std::string& robot_class) {
    const auto fits = [&](const Robot* robot) {
        return robot && !robot->isReplay() && robot->view().spawn.class_name == robot_class;
    };
    return fits(first) ? first : firstOf(robots, [&](const Robot* one) { return fits(one) && !one->running(); });
}

} // namespace usar::mission
