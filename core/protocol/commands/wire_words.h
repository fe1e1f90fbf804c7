// The words on the wire for the values of enumerations. The first word for a value is the one we write; UDK compares
// some of them case-sensitively.
#pragma once

#include <array>
#include <string_view>

#include "core/protocol/commands/joint.h"
#include "core/protocol/commands/package.h"
#include "core/protocol/commands/path_nodes.h"
#include "core/protocol/commands/trace.h"
#include "core/protocol/commands/view.h"
#include "core/protocol/commands/world_control.h"

namespace usar::protocol {

/// A table row: a word and the value that it stands for.
template <class Value>
struct WireWord {
    std::string_view word;
    Value value;
};
template <class Value>
WireWord(std::string_view, Value) -> WireWord<Value>; // Clang 14 cannot deduce it without this guide

/// The table of an enumeration; specialized below for each one that is sent over the wire.
template <class Value>
inline constexpr auto wire_words = nullptr;

template <>
inline constexpr std::array wire_words<JointOrder> = {
    WireWord{"0", JointOrder::Angle},          WireWord{"1", JointOrder::Speed},
    WireWord{"2", JointOrder::Torque},         WireWord{"3", JointOrder::Brake},
    WireWord{"10", JointOrder::RelativeAngle}, WireWord{"11", JointOrder::RelativeSpeed},
    WireWord{"12", JointOrder::RelativeTorque}};

template <>
inline constexpr std::array wire_words<JointOpcode> = {WireWord{"Angle", JointOpcode::Angle},
                                                       WireWord{"Target", JointOpcode::Angle},
                                                       WireWord{"Velocity", JointOpcode::Speed},
                                                       WireWord{"Torque", JointOpcode::Torque},
                                                       WireWord{"RelAngle", JointOpcode::RelativeAngle},
                                                       WireWord{"RelVelocity", JointOpcode::RelativeSpeed},
                                                       WireWord{"RelTorque", JointOpcode::RelativeTorque},
                                                       WireWord{"Stiffness", JointOpcode::Stiffness},
                                                       WireWord{"0", JointOpcode::Angle},
                                                       WireWord{"1", JointOpcode::Speed},
                                                       WireWord{"2", JointOpcode::Torque},
                                                       WireWord{"10", JointOpcode::RelativeAngle},
                                                       WireWord{"11", JointOpcode::RelativeSpeed},
                                                       WireWord{"12", JointOpcode::RelativeTorque}};

template <>
inline constexpr std::array wire_words<LinkOrder> = {WireWord{"0", LinkOrder::Angle}, WireWord{"1", LinkOrder::Speed},
                                                     WireWord{"2", LinkOrder::Torque}};

template <>
inline constexpr std::array wire_words<TraceColor> = {
    WireWord{"Red", TraceColor::Red},      WireWord{"Yellow", TraceColor::Yellow}, WireWord{"Green", TraceColor::Green},
    WireWord{"Cyan", TraceColor::Cyan},    WireWord{"White", TraceColor::White},   WireWord{"Blue", TraceColor::Blue},
    WireWord{"Purple", TraceColor::Purple}};

template <>
inline constexpr std::array wire_words<ViewLayout> = {WireWord{"SingleView", ViewLayout::Single},
                                                      WireWord{"QuadView", ViewLayout::Quad}};

template <>
inline constexpr std::array wire_words<ObjectPhysics> = {WireWord{"None", ObjectPhysics::None},
                                                         WireWord{"RigidBody", ObjectPhysics::RigidBody}};

template <>
inline constexpr std::array wire_words<Gait> = {WireWord{"Walk_Forward", Gait::WalkForward},
                                                WireWord{"Walk_Backward", Gait::WalkBackward},
                                                WireWord{"Run", Gait::Run}};

} // namespace usar::protocol
