// The segments of CONTROL, stated once for writing and reading (see drive_fields.h).
#pragma once

#include "core/protocol/commands/line_in.h"
#include "core/protocol/commands/line_out.h"
#include "core/protocol/commands/world_control.h"

namespace usar::protocol {

/// Begins the line with the Type that distinguishes the commands.
template <class Io>
void beginControl(Io& io, std::string_view type) {
    io.word("CONTROL");
    io.mark("Type", type);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<CreateObject> create) {
    beginControl(io, "Create");
    io.text("ClassName", create.class_name);
    io.text("Name", create.object_name);
    io.start(create.start);
    io.vector("Scale", create.scale);
    io.choice("Physics", create.physics);
    io.flag("Permanent", create.permanent);
    io.text("Memory", create.memory);
    io.text("Material", create.material);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<KillObject> kill) {
    beginControl(io, "Kill");
    io.text("Name", kill.object_name);
}

/// Converts a box; y and z change their signs on the wire, so that their minimum and maximum swap.
inline Box acrossWire(const Box& box) {
    return {{box.min_m.x(), -box.max_m.y(), -box.max_m.z()}, {box.max_m.x(), -box.min_m.y(), -box.min_m.z()}};
}
inline void fields(LineOut& out, const KillAllObjects& kill) {
    beginControl(out, "KillAll");
    if (kill.within) {
        const Box on_wire = acrossWire(*kill.within);
        out.vector("MinPos", on_wire.min_m);
        out.vector("MaxPos", on_wire.max_m);
    }
}
void fields(LineIn& in, KillAllObjects& kill);

template <class Io>
void fields(Io& io, typename Io::template Ref<PlaceObject> place) {
    beginControl(io, "AbsMove");
    io.text("Name", place.object_name);
    io.pose(place.object_in_map);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<ShiftObject> shift) {
    beginControl(io, "RelMove");
    io.text("Name", shift.object_name);
    io.pose(shift.shift);
}

/// Roll, pitch and yaw rates change sign in the same way as x, y and z.
template <class Io>
void fields(Io& io, typename Io::template Ref<SpinObject> spin) {
    beginControl(io, "Rotate");
    io.text("Name", spin.object_name);
    io.position("Speed", spin.rates_rad_s);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<RunConveyor> conveyor) {
    beginControl(io, "Conveyor");
    io.text("Name", conveyor.object_name);
    io.number("Speed", conveyor.speed_m_s);
}

inline void fields(LineOut& out, const AddWaypoints& add) {
    beginControl(out, "AddWP");
    out.text("Name", add.object_name);
    out.open("WP");
    for (std::size_t i = 0; i < add.points_in_map_m.size(); ++i) {
        out.add(i == 0 ? "" : ";");
        out.add(acrossWire(add.points_in_map_m[i]));
    }
    out.close();
}
void fields(LineIn& in, AddWaypoints& add);

template <class Io>
void fields(Io& io, typename Io::template Ref<ClearWaypoints> clear) {
    beginControl(io, "ClearWP");
    io.text("Name", clear.object_name);
}

/// Speed, or Time for the whole path.
inline void pace(LineOut& out, const std::variant<WaypointSpeed, Seconds>& pace) {
    if (const auto* const speed = std::get_if<WaypointSpeed>(&pace))
        out.number("Speed", speed->speed_m_s);
    else
        out.seconds("Time", std::get<Seconds>(pace));
}
void pace(LineIn& in, std::variant<WaypointSpeed, Seconds>& pace);

template <class Io>
void fields(Io& io, typename Io::template Ref<FollowWaypoints> follow) {
    beginControl(io, "SetWP");
    io.text("Name", follow.object_name);
    pace(io, follow.pace);
    io.flag("Loop", follow.loop);
    io.flag("ResetOnClear", follow.reset_on_clear);
    io.flag("Moving", follow.moving);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<GetObjectStates> get) {
    beginControl(io, "GetSTA");
    io.text("Name", get.object_name);
    io.text("ClassName", get.class_name);
}

} // namespace usar::protocol
