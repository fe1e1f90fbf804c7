// SET of cameras and of the screen that shows them.
#pragma once

#include <array>

#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// The angle of view; 0 goes back to the default, and what is out of limits is cut by the server.
struct ZoomCamera {
    double field_of_view_rad = 0.0;
    Name camera_name{};
    bool operator==(const ZoomCamera&) const = default;
};

/// The picture on the viewer at this address shows that camera from now on.
struct AttachCamera {
    Token robot_name;
    Token client_address;
    Name camera_name{};
    bool operator==(const AttachCamera&) const = default;
};
struct DetachCamera {
    Token client_address;
    bool operator==(const DetachCamera&) const = default;
};

/// How the game's window is cut, and what each part shows: a camera's name, "Disabled", "None", or as it was.
enum class ViewLayout { Single, Quad };
struct SetViewports {
    ViewLayout layout = ViewLayout::Single;
    std::array<Name, 4> views{}; ///< top left, top right, bottom left, bottom right
    bool operator==(const SetViewports&) const = default;
};

} // namespace usar::protocol
