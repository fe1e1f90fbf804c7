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

bool PlanPins::release(const PlanSpot& spot) {
    const auto is_of_spot = [&](const auto& pin) { return pin.call == spot.call; };
    return (spot.kind == posh::PlaceKind::Act ? std::erase_if(pins_.acts, is_of_spot)
                                              : std::erase_if(pins_.senses, is_of_spot)) > 0;
}

void PlanPins::toggleDrive(const PlanSpot& spot) {
    const agent::DriveOff drive{spot.path, spot.names};
    if (std::erase(pins_.drives_off, drive) == 0)
        pins_.drives_off.push_back(drive);
}

} // namespace usar::widgets
