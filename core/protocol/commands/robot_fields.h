// The segments of all commands that have no file of their own, stated once for writing and reading (see
// drive_fields.h).
#pragma once

#include "core/protocol/commands/line_in.h"
#include "core/protocol/commands/line_out.h"
#include "core/protocol/commands/package.h"
#include "core/protocol/commands/query.h"
#include "core/protocol/commands/simulation.h"
#include "core/protocol/commands/spawn.h"
#include "core/protocol/commands/trace.h"

namespace usar::protocol {

/// The pose that accompanies a start name.
inline void fallback(LineOut& out, const Init& init) {
    if (init.fallback_in_map && std::holds_alternative<Token>(init.start))
        out.pose(*init.fallback_in_map);
}
inline void fallback(LineIn& in, Init& init) {
    if (std::holds_alternative<Token>(init.start))
        init.fallback_in_map = in.pose();
}

template <class Io>
void fields(Io& io, typename Io::template Ref<Init> init) {
    io.word("INIT");
    io.text("ClassName", init.class_name);
    io.text("Name", init.robot_name);
    io.start(init.start);
    fallback(io, init);
    io.seconds("Battery", init.battery_life);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<GetStartPoses>) {
    io.word("GETSTARTPOSES");
}

/// Corrects the case of the words for the robot and its packages, because UDK compares them case-sensitively.
inline void askedType(LineOut& out, const Token& type) {
    for (const std::string_view exact : {"Robot", "MisPkg", "Actuator"}) {
        if (sameWord(type.text(), exact))
            return out.mark("Type", exact);
    }
    out.text("Type", type);
}
inline void askedType(LineIn& in, Token& type) {
    in.text("Type", type);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<GetGeometry> get) {
    io.word("GETGEO");
    askedType(io, get.type);
    io.text("Name", get.name);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<GetConfiguration> get) {
    io.word("GETCONF");
    askedType(io, get.type);
    io.text("Name", get.name);
}

/// Link and its values, for each link.
inline void links(LineOut& out, const std::vector<LinkTarget>& links) {
    for (const LinkTarget& target : links) {
        out.whole("Link", target.link);
        out.number("Value", target.value);
        out.choice("Order", target.order);
    }
}
void links(LineIn& in, std::vector<LinkTarget>& links);

inline void links(LineOut& out, const std::vector<LinkValue>& links) {
    for (const LinkValue& target : links) {
        out.whole("Link", target.link);
        out.number("Value", target.value);
    }
}
void links(LineIn& in, std::vector<LinkValue>& links);

template <class Io>
void fields(Io& io, typename Io::template Ref<PackageDrive> drive) {
    io.word("MISPKG");
    io.text("Name", drive.package);
    links(io, drive.links);
    io.whole("Seq", drive.sequence);
    io.digit("Gripper", drive.gripper_closed);
}

inline void fields(LineOut& out, const PackageRotation& rotation) {
    out.word("MISPKG");
    out.text("Name", rotation.package);
    out.vector("Rotation", Vec3(0.0, rotation.tilt_rad, rotation.pan_rad));
    out.choice("Order", rotation.order);
}
void fields(LineIn& in, PackageRotation& rotation);

template <class Io>
void fields(Io& io, typename Io::template Ref<ActuatorDrive> drive) {
    io.word("ACT");
    io.text("Name", drive.actuator);
    links(io, drive.links);
    io.digit("Gripper", drive.gripper_closed);
    io.whole("Sequence", drive.sequence);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<Trace> trace) {
    io.word("TRACE");
    io.flag("On", trace.on);
    io.seconds("Interval", trace.interval);
    io.choice("Color", trace.color);
}

inline void fields(LineOut& out, const Lockstep& lockstep) {
    out.word("LOCKSTEP");
    out.flag("On", lockstep.on);
}
void fields(LineIn& in, Lockstep& lockstep);

template <class Io>
void fields(Io& io, typename Io::template Ref<Step>) {
    io.word("STEP");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<Test>) {
    io.word("TEST");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<Pause> pause) {
    io.word("PAUSE");
    io.seconds("Time", pause.time);
}

} // namespace usar::protocol
