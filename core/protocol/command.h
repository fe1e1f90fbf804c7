// Everything a client can ask of a server, as one variant of small structs in our frame and in SI units.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/base/sealed.h"
#include "core/protocol/commands/drive.h"
#include "core/protocol/commands/joint.h"
#include "core/protocol/commands/package.h"
#include "core/protocol/commands/path_nodes.h"
#include "core/protocol/commands/query.h"
#include "core/protocol/commands/set.h"
#include "core/protocol/commands/simulation.h"
#include "core/protocol/commands/spawn.h"
#include "core/protocol/commands/trace.h"
#include "core/protocol/commands/view.h"
#include "core/protocol/commands/world_control.h"

namespace usar::protocol {

/// Any other line, without its line end. A client sends it unchanged; our server keeps a line in this form if it does
/// not know the command.
struct RawCommand {
    std::string line{};
    bool operator==(const RawCommand&) const = default;
};

using CommandVariant =
    std::variant<RawCommand, Init, GetStartPoses, AerialDrive, SkidDrive, AckermannDrive, OmniDrive, NauticDrive,
                 JointDrive, MultiDrive, DriveSwitches, GetGeometry, GetConfiguration, SetInsPose, ResetSensor, ScanNow,
                 ReadTag, WriteTag, ReleaseTag, CountTags, UseGripper, UseToolChanger, SetItem, SetJoint, ZoomCamera,
                 AttachCamera, DetachCamera, SetViewports, PackageDrive, PackageRotation, ActuatorDrive, Trace,
                 CreateObject, KillObject, KillAllObjects, PlaceObject, ShiftObject, SpinObject, RunConveyor,
                 AddWaypoints, ClearWaypoints, FollowWaypoints, GetObjectStates, GetPathNodes, GetClosestPathNode,
                 GoToNode, WalkTo, PauseWalk, ResumeWalk, Lockstep, Step, Test, Pause>;

/// A command; a variant of all of them.
using Command = Sealed<CommandVariant>;

/// True for any kind of DRIVE and MULTIDRIVE: commands that move a robot and replace the previous command of that kind.
bool isDrive(const Command& command);

} // namespace usar::protocol

extern template class usar::Sealed<usar::protocol::CommandVariant>;
