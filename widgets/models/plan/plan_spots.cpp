#include "widgets/models/plan/plan_spots.h"

namespace usar::widgets {

std::vector<PlanSpot> spotsOfNode(const posh::Program& program, const std::vector<std::string>& paths,
                                  const PlanTree& tree, PlanNodeId node) {
    std::vector<PlanSpot> spots;
    if (!node.valid())
        return spots;
    for (posh::Index place = 0; place < paths.size(); ++place) {
        const PlanNodeId drawn = tree.find(paths[place]);
        if (drawn == node || (drawn.valid() && tree[drawn].link == node))
            spots.push_back({paths[place], posh::namePathOf(program, place), posh::callTextAt(program, place),
                             program.places[place].kind});
    }
    return spots;
}

} // namespace usar::widgets
