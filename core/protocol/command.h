// Everything a client can ask, as one variant of small structs in our frame and in SI units.
#pragma once

#include <string>
#include <variant>

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

/// Any other line, sent as it is and kept whole by a server that does not know it.
struct RawCommand {
    std::string line{};
    bool operator==(const RawCommand&) const = default;
};

using Command =
    std::variant<RawCommand, Init, GetStartPoses, AerialDrive, SkidDrive, AckermannDrive, OmniDrive, NauticDrive,
                 JointDrive, MultiDrive, DriveSwitches, GetGeometry, GetConfiguration, SetInsPose, ResetSensor, ScanNow,
                 ReadTag, WriteTag, ReleaseTag, CountTags, UseGripper, UseToolChanger, SetItem, SetJoint, ZoomCamera,
                 AttachCamera, DetachCamera, SetViewports, PackageDrive, PackageRotation, ActuatorDrive, Trace,
                 CreateObject, KillObject, KillAllObjects, PlaceObject, ShiftObject, SpinObject, RunConveyor,
                 AddWaypoints, ClearWaypoints, FollowWaypoints, GetObjectStates, GetPathNodes, GetClosestPathNode,
                 GoToNode, WalkTo, PauseWalk, ResumeWalk, Lockstep, Step, Test, Pause>;

/// DRIVE and MULTIDRIVE of any kind: what moves a robot and replaces what was said before.
bool isDrive(const Command& command);

} // namespace usar::protocol
