// SET commands for cameras and for the screen that shows them.
#pragma once

#include <array>

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/set_word.h"

namespace usar::protocol {

/// Sets the angle of view of a camera. 0 restores the default; the server limits the angle to the camera's range.
/// On the wire: `SET {Type Camera} {Name Camera} {Opcode Zoom} {Params 0.5}`.
struct ZoomCamera {
    /// The opcode FOV is read like Zoom.
    double field_of_view_rad = 0.0;
    Name camera_name{};
    bool operator==(const ZoomCamera&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "Camera");
        io.text(set_name, set.camera_name);
        io.mark(set_opcode, "Zoom", "FOV");
        io.number({"Params", "Camera: radians"}, set.field_of_view_rad, {.keyless = true});
    }
};

/// The address identifies the viewer, as the image server sees it.
inline constexpr Key viewer_key{"Client", "the viewer's address; alone it detaches the viewer"};

/// Makes the viewer at `client_address` show the given camera of the given robot.
/// On the wire: `SET {Type Camera} {Robot R1} {Name GCam} {Client 10.0.0.2}`.
struct AttachCamera {
    Token robot_name;
    Token client_address;
    Name camera_name{};
    bool operator==(const AttachCamera&) const = default;

    static constexpr auto& word = set_word;
    static constexpr auto signs = texts("Robot");
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "Camera");
        io.text({"Robot", "the robot whose camera to show"}, set.robot_name);
        io.text(set_name, set.camera_name);
        io.text(viewer_key, set.client_address);
    }
};
/// Ends this for the viewer at `client_address`.
/// On the wire: `SET {Type Camera} {Client 10.0.0.2}`.
struct DetachCamera {
    Token client_address;
    bool operator==(const DetachCamera&) const = default;

    static constexpr auto& word = set_word;
    static constexpr auto signs = texts("Client");
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "Camera");
        io.text(viewer_key, set.client_address);
    }
};

/// One viewport for the whole window, or four of a quarter each.
enum class ViewLayout { Single, Quad };
template <>
inline constexpr std::array wire_words<ViewLayout> = {WireWord{"SingleView", ViewLayout::Single},
                                                      WireWord{"QuadView", ViewLayout::Quad}};

/// Divides the game's window into viewports and sets what each one shows: the name of a camera, "Disabled" or "None".
/// An empty name leaves the viewport unchanged.
/// On the wire: `SET {Type Viewports} {Config QuadView} {Viewport1 Cam1} {Viewport2 Disabled}`.
struct SetViewports {
    ViewLayout layout = ViewLayout::Single;
    std::array<Name, 4> views{}; ///< top left, top right, bottom left, bottom right
    bool operator==(const SetViewports&) const = default;

    static constexpr auto& word = set_word;
    static constexpr auto signs = texts("Config");
    static constexpr auto usual_views = texts("Disabled", "None");
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "Viewports");
        io.choice({"Config", "how the screen is cut (UT2004)"}, set.layout);
        constexpr std::array keys = {"Viewport1", "Viewport2", "Viewport3", "Viewport4"};
        for (std::size_t i = 0; i < keys.size(); ++i)
            io.text({keys[i], "a camera, Disabled or None", usual_views}, set.views[i]);
    }
};

} // namespace usar::protocol
