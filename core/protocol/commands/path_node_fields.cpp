#include "core/protocol/commands/path_node_fields.h"

namespace usar::protocol {

void goal(LineIn& in, std::variant<Vec2, Token>& goal) {
    if (in.segments().find("Pathnode"))
        return in.text("Pathnode", goal.emplace<Token>("?"));
    const Segment* const location = in.segments().find("Location");
    if (!location)
        return in.refuse(in.segments().line(), "MOVE needs a Location or a Pathnode");
    const auto [x, y] = in.numbersOf<2>(*location);
    goal = Vec2(acrossWire(Vec3(x, y, 0.0)).head<2>());
}

} // namespace usar::protocol
