#include "robots/ers/descriptions.h"

#include "robots/ers/kicker_behavior.h"

namespace usar::ers {

ErsRobot::ErsRobot() : ListedRobot("USARBot.ERS", "ERS", {"Helper", "INS"}) {
    add<KickerBehavior>({.id = "ers/cpp",
                         .name = "After the ball (C++)",
                         .help = "Walks in circles until it sees the ball, walks to it with its eyes on it, and kicks "
                                 "it by walking on. Marks its way with TRACE.",
                         .parameters = Settings::parameters.specs()});
}

} // namespace usar::ers
