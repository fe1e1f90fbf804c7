// A robot plugin as a list: a description of the robot, and for each behavior the code that creates it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/posh/posh_behavior.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// Derive from it and call `add` and `addPlanned` in the constructor. It has no QObject, so that tests can link it; the
/// plugin derives from both.
class ListedRobot : public RobotPlugin {
public:
    RobotDescription description() const override { return robot_; }
    Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const override;

protected:
    /// `class_name` and `sensors_needed` are as in RobotDescription.
    ListedRobot(std::string class_name, std::string name, std::vector<std::string> sensors_needed);

    /// Adds a behavior of class `Made`, which is constructed from a BehaviorContext.
    template <class Made>
    void add(BehaviorDescription behavior) {
        robot_.behaviors.push_back(std::move(behavior));
        makers_.push_back([](BehaviorContext context) -> Result<std::unique_ptr<Behavior>> {
            return std::make_unique<Made>(std::move(context));
        });
    }
    /// Adds the behavior that was added last once more, with another id and name, but decided by a plan: the one in its
    /// context, or else `own`. `Body` is constructed from a BehaviorContext, and `registry` has its senses and acts.
    template <class Body>
    void addPlanned(std::string id, std::string name, const PlanText& own, const PoshRegistry& registry) {
        describePlanned(std::move(id), std::move(name), own, registry);
        makers_.push_back([own, registry](BehaviorContext context) -> Result<std::unique_ptr<Behavior>> {
            const PlanText plan = context.plan.value_or(own);
            return PoshBehavior::make({plan.name, plan.text, registry, std::make_unique<Body>(std::move(context)), {}});
        });
    }

private:
    void describePlanned(std::string id, std::string name, const PlanText& plan, const PoshRegistry& registry);

    RobotDescription robot_;
    /// One for each of the robot's behaviors.
    std::vector<std::function<Result<std::unique_ptr<Behavior>>(BehaviorContext)>> makers_;
};

} // namespace usar::agent
