#include "robots/submarine/descriptions.h"

#include "robots/submarine/diver_behavior.h"

namespace usar::submarine {

namespace {
const char* const diver_id = "submarine/cpp";
} // namespace

agent::RobotDescription describeSubmarine() {
    agent::BehaviorDescription diver;
    diver.id = diver_id;
    diver.name = "Along the bottom (C++)";
    diver.help = "Asks for its configuration, then keeps its height over the bottom by the ray on its belly, turns by "
                 "the rudder while it is level, backs off from what rises before it, and lets its camera look around.";
    diver.parameters = parameterSpecs();
    return {"USARBot.Submarine", "Submarine", {"Range"}, {std::move(diver)}};
}

Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context) {
    if (id != diver_id)
        return failure("the Submarine has no such behavior", "behavior " + id, std::string("Use ").append(diver_id));
    return std::make_unique<DiverBehavior>(std::move(context));
}

} // namespace usar::submarine
