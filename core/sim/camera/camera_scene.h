// Everything that cameras can see at one moment, by value: any thread can make a picture of it while the simulation
// continues.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/usual_values.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/articulation.h"

namespace usar::sim {

/// Red, green, blue, from 0 to 1; larger values are too bright and are clipped.
using Color = Eigen::Array3f;

/// One convex part of something that moves, or that only cameras see.
struct SeenSolid {
    Shape shape;
    Vec3 center_m = Vec3::Zero();
    /// Rotation alone; the place is `center_m`, in the map frame.
    Eigen::Matrix3d solid_in_map = Eigen::Matrix3d::Identity();
    double radius_m = 0.0; ///< radius of a sphere around its center that encloses it
    Color color = Color::Constant(0.5f);
};

/// A lamp on a robot, which throws a cone of light. Map frame; `direction` is a unit vector.
struct SeenLamp {
    Vec3 position_m = Vec3::Zero();
    Vec3 direction = Vec3::UnitX();
};

/// A camera and its current pose. Its x axis points into the picture, y left, z up.
struct SeenFrom {
    std::string robot{};
    std::string camera{};
    Eigen::Isometry3d camera_in_map = Eigen::Isometry3d::Identity();
    double field_of_view_rad = protocol::usual_camera_fov_rad; ///< horizontally
    /// Size of the picture.
    int width_px = 320;
    int height_px = 240;
};

/// The camera that a viewer wants to see.
struct CameraChoice {
    std::string robot;
    std::string camera; ///< empty: the robot's first camera
    bool operator==(const CameraChoice&) const = default;
};

/// How a client has divided the window (SET {Type Viewports}): one camera, or four, from the top left row by row. A
/// part without a camera stays black.
struct Viewports {
    /// If false, only the first camera counts.
    bool four = false;
    std::array<std::optional<CameraChoice>, 4> cameras{};
    bool operator==(const Viewports&) const = default;
};

/// Everything that cameras can see at one tick of a simulation.
struct CameraScene {
    std::shared_ptr<const StillWorld> still; ///< never null
    std::uint64_t tick = 0;                  ///< equal ticks of one simulation show the same
    std::vector<SeenSolid> solids{};         ///< robots, objects, victims and tags
    /// Only the lamps that are on.
    std::vector<SeenLamp> lamps{};
    std::vector<SeenFrom> cameras{};                ///< in the order of the robots' connections
    std::map<std::string, CameraChoice> attached{}; ///< by the viewer's address
    std::optional<Viewports> viewports{};           ///< nullopt: no client has set them
};

} // namespace usar::sim
