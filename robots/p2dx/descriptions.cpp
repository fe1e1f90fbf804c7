#include "robots/p2dx/descriptions.h"

#include "robots/p2dx/explorer_behavior.h"
#include "robots/p2dx/explorer_body.h"

namespace usar::p2dx {

extern const char explorer_plan_text[]; // Contents of resources/plans/p2dx.lap

P2dxRobot::P2dxRobot() : ListedRobot("USARBot.P2DX", "P2DX", {"RangeScanner", "Sonar", "INS"}) {
    add<ExplorerBehavior>({.id = "p2dx/cpp",
                           .name = "Most open direction (C++)",
                           .help = "Heads for the most open third of the laser's view, backs away and turns where "
                                   "something is too close ahead, and turns around where it gets no further. Stays in "
                                   "the area, if there is one.",
                           .parameters = Settings::parameters.specs()});
    addPlanned<ExplorerBody>("p2dx/posh", "Most open direction (POSH)", {"p2dx.lap", explorer_plan_text},
                             agent::registryOf<ExplorerBody>({addExplorerSenses, addExplorerActs}));
}

} // namespace usar::p2dx
