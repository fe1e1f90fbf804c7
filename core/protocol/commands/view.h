// SET commands for cameras and for the screen that shows them.
#pragma once

#include <array>

#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// Sets the angle of view of a camera. 0 restores the default; the server limits the angle to the camera's range.
/// On the wire: `SET {Type Camera} {Name Camera} {Opcode Zoom} {Params 0.5}`.
struct ZoomCamera {
    double field_of_view_rad = 0.0;
    Name camera_name{};
    bool operator==(const ZoomCamera&) const = default;
};

/// Makes the viewer at `client_address` show the given camera of the given robot.
/// On the wire: `SET {Type Camera} {Robot R1} {Name GCam} {Client 10.0.0.2}`.
struct AttachCamera {
    Token robot_name;
    Token client_address;
    Name camera_name{};
    bool operator==(const AttachCamera&) const = default;
};
/// Ends this for the viewer at `client_address`.
/// On the wire: `SET {Type Camera} {Client 10.0.0.2}`.
struct DetachCamera {
    Token client_address;
    bool operator==(const DetachCamera&) const = default;
};

enum class ViewLayout { Single, Quad };
/// Divides the game's window into viewports and sets what each one shows: the name of a camera, "Disabled" or "None".
/// An empty name leaves the viewport unchanged.
/// On the wire: `SET {Type Viewports} {Config QuadView} {Viewport1 Cam1} {Viewport2 Disabled}`.
struct SetViewports {
    ViewLayout layout = ViewLayout::Single;
    std::array<Name, 4> views{}; ///< top left, top right, bottom left, bottom right
    bool operator==(const SetViewports&) const = default;
};

} // namespace usar::protocol
