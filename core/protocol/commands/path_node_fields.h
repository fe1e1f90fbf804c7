// The segments of commands about path nodes and avatars, stated once for writing and reading (see drive_fields.h).
#pragma once

#include "core/protocol/commands/line_in.h"
#include "core/protocol/commands/line_out.h"
#include "core/protocol/commands/path_nodes.h"

namespace usar::protocol {

template <class Io>
void fields(Io& io, typename Io::template Ref<GetPathNodes>) {
    io.word("GETPATHNODES");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<GetClosestPathNode> get) {
    io.word("GETCLOSESTPATHNODE");
    io.position("Location", get.point_in_map_m);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<GoToNode> go) {
    io.word("GOTO");
    io.text("Name", go.node_name);
}

/// Location with two numbers, or Pathnode.
inline void goal(LineOut& out, const std::variant<Vec2, Token>& goal) {
    if (const Token* const node = std::get_if<Token>(&goal)) {
        out.text("Pathnode", *node);
    } else {
        const Vec3 on_wire = acrossWire(Vec3(std::get<Vec2>(goal).x(), std::get<Vec2>(goal).y(), 0.0));
        out.open("Location");
        out.add(on_wire.x());
        out.add(",");
        out.add(on_wire.y());
        out.close();
    }
}
void goal(LineIn& in, std::variant<Vec2, Token>& goal);

inline void action(LineOut& out, bool append) {
    out.mark("Action", append ? "Append" : "New");
}
inline void action(LineIn& in, bool& append) {
    append = sameWord(in.segments().value("Action"), "Append");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<WalkTo> walk) {
    io.word("MOVE");
    action(io, walk.append);
    io.choice("Type", walk.gait);
    goal(io, walk.goal);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<PauseWalk>) {
    io.word("MOVE");
    io.mark("Action", "Pause");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<ResumeWalk>) {
    io.word("MOVE");
    io.mark("Action", "Resume");
}

} // namespace usar::protocol
