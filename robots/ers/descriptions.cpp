#include "robots/ers/descriptions.h"

#include "robots/ers/kicker_behavior.h"

namespace usar::ers {

namespace {
const char* const kicker_id = "ers/cpp";
} // namespace

agent::RobotDescription describeErs() {
    agent::BehaviorDescription kicker;
    kicker.id = kicker_id;
    kicker.name = "After the ball (C++)";
    kicker.help = "Walks in circles until it sees the ball, walks to it with its eyes on it, and kicks it by walking "
                  "on. Marks its way with TRACE.";
    kicker.parameters = parameterSpecs();
    return {"USARBot.ERS", "ERS", {"Helper", "INS"}, {std::move(kicker)}};
}

Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context) {
    if (id != kicker_id)
        return failure("the ERS has no such behavior", "behavior " + id, std::string("Use ") + kicker_id);
    return std::make_unique<KickerBehavior>(std::move(context));
}

} // namespace usar::ers
