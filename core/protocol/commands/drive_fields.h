// The segments of DRIVE and MULTIDRIVE, stated once for writing and reading.
//
// `fields(io, command)` passes each segment of a command, in the order of the wire, to `io`: a LineOut writes the line,
// a LineIn reads the values into the command. `Io::Ref<T>` is const T& for writing and T& for reading. Commands whose
// two directions differ have an overload for each. The other *_fields.h work in the same way.
#pragma once

#include "core/protocol/commands/drive.h"
#include "core/protocol/commands/joint.h"
#include "core/protocol/commands/line_in.h"
#include "core/protocol/commands/line_out.h"

namespace usar::protocol {

/// The segments that may accompany any DRIVE.
template <class Io>
void switches(Io& io, typename Io::template Ref<DriveSwitches> switches) {
    io.flag("Light", switches.light_on);
    io.flag("Flip", switches.flip);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<DriveSwitches> value) {
    io.word("DRIVE");
    switches(io, value);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<SkidDrive> drive) {
    io.word("DRIVE");
    io.beginScale(drive.normalized);
    io.speed("Left", drive.left_rad_s);
    io.speed("Right", drive.right_rad_s);
    io.endScale();
    switches(io, drive.switches);
}

/// Sets absent values to 0, because UDK obeys only if all three are there.
inline AckermannDrive complete(AckermannDrive drive) {
    drive.speed_rad_s = drive.speed_rad_s.value_or(0.0);
    drive.front_steer_rad = drive.front_steer_rad.value_or(0.0);
    drive.rear_steer_rad = drive.rear_steer_rad.value_or(0.0);
    return drive;
}

template <class Io>
void ackermannFields(Io& io, typename Io::template Ref<AckermannDrive> drive) {
    io.word("DRIVE");
    io.beginScale(drive.normalized);
    io.speed("Speed", drive.speed_rad_s);
    io.flipped("FrontSteer", drive.front_steer_rad);
    io.flipped("RearSteer", drive.rear_steer_rad);
    io.endScale();
    switches(io, drive.switches);
}
inline void fields(LineIn& in, AckermannDrive& drive) {
    ackermannFields(in, drive);
}
inline void fields(LineOut& out, const AckermannDrive& drive) {
    ackermannFields(out, out.dialect() == Dialect::Udk ? complete(drive) : drive);
}

/// WheelNumber and the values of that wheel, for each wheel.
inline void wheels(LineOut& out, const std::vector<WheelDrive>& wheels) {
    for (const WheelDrive& wheel : wheels) {
        out.whole("WheelNumber", wheel.wheel);
        out.number("WheelSpeed", wheel.spin_rad_s);
        out.flipped("WheelSteer", wheel.steer_rad);
    }
}
void wheels(LineIn& in, std::vector<WheelDrive>& wheels);

template <class Io>
void fields(Io& io, typename Io::template Ref<OmniDrive> drive) {
    io.word("DRIVE");
    wheels(io, drive.wheels);
    io.beginScale(drive.normalized);
    io.endScale();
    switches(io, drive.switches);
}

/// UDK expects the yaw rate in degrees per second, but not if speeds are in percent.
template <class Io>
void fields(Io& io, typename Io::template Ref<AerialDrive> drive) {
    io.word("DRIVE");
    io.beginScale(drive.normalized);
    io.speed("AltitudeVelocity", drive.climb_m_s);
    io.speed("LinearVelocity", drive.forward_m_s);
    io.flippedSpeed("LateralVelocity", drive.left_m_s);
    if (io.dialect() == Dialect::Udk && !drive.normalized)
        io.flippedDegrees("RotationalVelocity", drive.yaw_rate_rad_s);
    else
        io.flippedSpeed("RotationalVelocity", drive.yaw_rate_rad_s);
    io.endScale();
    io.flippedDegrees("PitchAngle", drive.pitch_rad);
    io.degrees("RollAngle", drive.roll_rad);
    switches(io, drive.switches);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<NauticDrive> drive) {
    io.word("DRIVE");
    io.beginScale(drive.normalized);
    io.speed("Propeller", drive.propeller_rad_s);
    io.number("Rudder", drive.rudder_rad);
    io.number("SternPlane", drive.stern_plane_rad);
    io.endScale();
    switches(io, drive.switches);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<JointDrive> drive) {
    io.word("DRIVE");
    io.text("Name", drive.joint);
    io.choice("Order", drive.order);
    io.beginScale(drive.normalized);
    io.number("Value", drive.value);
    io.flipped("Steer", drive.steer_rad);
    io.endScale();
    switches(io, drive.switches);
}

/// A segment for each joint, with the joint's name as its key.
inline void fields(LineOut& out, const MultiDrive& drive) {
    out.word("MULTIDRIVE");
    for (const JointAngleTarget& target : drive.joints)
        out.number(target.joint.text(), target.angle_rad);
}
void fields(LineIn& in, MultiDrive& drive);

} // namespace usar::protocol
