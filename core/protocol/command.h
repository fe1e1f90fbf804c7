// Everything a client can ask of a server, as one variant of small structs in our frame and in SI units. A new command
// takes a struct in the folder commands, which describes itself (commands/description.h), and an entry here; reading,
// writing, completion, checks and help follow from it.
#pragma once

#include <string>
#include <variant>

#include "core/base/sealed.h"
#include "core/protocol/commands/drive.h"
#include "core/protocol/commands/flight.h"
#include "core/protocol/commands/joint.h"
#include "core/protocol/commands/object_motion.h"
#include "core/protocol/commands/package.h"
#include "core/protocol/commands/path_nodes.h"
#include "core/protocol/commands/query.h"
#include "core/protocol/commands/set.h"
#include "core/protocol/commands/simulation.h"
#include "core/protocol/commands/spawn.h"
#include "core/protocol/commands/tags.h"
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

/// All commands, in the order in which help lists them. Of several commands with one word the reader takes the first
/// that fits (commands/description.h): aerial drives come before the others because Iridium's stop button sends the
/// keys of all vehicles at once.
using CommandVariant =
    std::variant<RawCommand, Init, GetStartPoses, AerialDrive, SkidDrive, AckermannDrive, OmniDrive, NauticDrive,
                 JointDrive, DriveSwitches, MultiDrive, GetGeometry, GetConfiguration, SetInsPose, SetJoint, ZoomCamera,
                 ReadTag, WriteTag, ReleaseTag, CountTags, UseGripper, UseToolChanger, ResetSensor, ScanNow, SetItem,
                 AttachCamera, DetachCamera, SetViewports, PackagePose, PackageRotation, PackageDrive, ActuatorDrive,
                 Trace, CreateObject, KillObject, KillAllObjects, PlaceObject, ShiftObject, SpinObject, RunConveyor,
                 AddWaypoints, ClearWaypoints, FollowWaypoints, GetObjectStates, GetPathNodes, GetClosestPathNode,
                 GoToNode, WalkTo, PauseWalk, ResumeWalk, Test, Pause, Lockstep, Step>;

/// A command; a variant of all of them.
using Command = Sealed<CommandVariant>;

/// True for any kind of DRIVE and MULTIDRIVE: commands that move a robot and replace the previous command of that kind.
bool isDrive(const Command& command);

} // namespace usar::protocol

extern template class usar::Sealed<usar::protocol::CommandVariant>;
