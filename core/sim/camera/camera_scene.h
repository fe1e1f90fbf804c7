// What cameras can see at one moment, by value: a picture of it can be made in any thread while the simulation goes on.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/sim/articulation.h"
#include "core/sim/still_world.h"

namespace usar::sim {

/// Red, green, blue, 0 to 1 (more is too bright and is cut).
using Color = Eigen::Array3f;

/// One convex part of something that moves, or that only cameras see.
struct SeenSolid {
    std::variant<CylinderShape, CapsuleShape, BoxShape, SphereShape> shape;
    Vec3 center_m = Vec3::Zero();
    Eigen::Matrix3d solid_in_map = Eigen::Matrix3d::Identity();
    double radius_m = 0.0; ///< of a sphere around it
    Color color = Color::Constant(0.5f);
};

/// A lamp on a robot: a cone of light.
struct SeenLamp {
    Vec3 position_m = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();
};

/// A camera as it stands now: x into the picture, y left, z up.
struct SeenFrom {
    std::string robot;
    std::string camera;
    Eigen::Isometry3d camera_in_map = Eigen::Isometry3d::Identity();
    double field_of_view_rad = 1.396; ///< across the width
    int width_px = 320;
    int height_px = 240;
};

/// Which camera a viewer wants to see.
struct CameraChoice {
    std::string robot;
    std::string camera; ///< empty: the robot's first one
    bool operator==(const CameraChoice&) const = default;
};

/// How the window is cut where a client has said so (SET {Type Viewports}): one camera, or four, from the top left.
/// Without a camera a part stays black.
struct Viewports {
    bool four = false;
    std::array<std::optional<CameraChoice>, 4> cameras{};
    bool operator==(const Viewports&) const = default;
};

struct CameraScene {
    std::shared_ptr<const StillWorld> still;
    std::uint64_t tick = 0; ///< of one simulation: equal ticks show the same
    std::vector<SeenSolid> solids;
    std::vector<SeenLamp> lamps;
    std::vector<SeenFrom> cameras;                ///< in the order of the robots' connections
    std::map<std::string, CameraChoice> attached; ///< by the address of the viewer
    std::optional<Viewports> viewports{};
};

} // namespace usar::sim
