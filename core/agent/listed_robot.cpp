#include "core/agent/listed_robot.h"

namespace usar::agent {

ListedRobot::ListedRobot(std::string class_name, std::string name, std::vector<std::string> sensors_needed)
    : robot_{std::move(class_name), std::move(name), std::move(sensors_needed), {}} {}

Result<std::unique_ptr<Behavior>> ListedRobot::createBehavior(const std::string& id, BehaviorContext context) const {
    std::string known;
    for (std::size_t i = 0; i < makers_.size(); ++i) {
        if (robot_.behaviors[i].id == id)
            return makers_[i](std::move(context));
        known += (known.empty() ? "" : " or ") + robot_.behaviors[i].id;
    }
    return failure("the " + robot_.name + " has no such behavior", "behavior " + id, "Use " + known);
}

void ListedRobot::describePlanned(std::string id, std::string name, const PlanText& plan,
                                  const PoshRegistry& registry) {
    BehaviorDescription planned = robot_.behaviors.back();
    planned.id = std::move(id);
    planned.name = std::move(name);
    planned.help += " Decided by a POSH plan, which can be read and changed.";
    planned.plan_name = plan.name;
    planned.plan_text = plan.text;
    robot_.behaviors.push_back(std::move(planned));
    robot_.primitives = registry.descriptions();
}

} // namespace usar::agent
