#include "robots/submarine/descriptions.h"

#include "robots/submarine/diver_behavior.h"

namespace usar::submarine {

SubmarineRobot::SubmarineRobot() : ListedRobot("USARBot.Submarine", "Submarine", {"Range"}) {
    add<DiverBehavior>({.id = "submarine/cpp",
                        .name = "Along the bottom (C++)",
                        .help = "Asks for its configuration, then keeps its height over the bottom by the ray on its "
                                "belly, turns by the rudder while it is level, backs off from what rises before it, "
                                "and lets its camera look around.",
                        .parameters = Settings::parameters.specs()});
}

} // namespace usar::submarine
