// What the map shows, as plain values: filled by MapView's setters, read by its painters.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <QImage>
#include <QString>

#include "core/agent/published.h"
#include "core/protocol/info/game_info.h"
#include "widgets/models/area_grip.h"
#include "widgets/models/map_object.h"
#include "widgets/models/radio_links.h"
#include "widgets/models/trail.h"

namespace usar::widgets {

/// Painted in this order, lowest first.
enum class MapLayer {
    World,
    Grid,
    Heights,
    Area,
    Lanes,
    Trails,
    Traces,
    Marks,
    Objects,
    StartPoses,
    Laser,
    Goals,
    Radio,
    Robots
};
inline constexpr std::size_t map_layer_count = 14;
/// "Height map": what menus and the layers panel call it.
QString layerName(MapLayer layer);

/// A hidden layer keeps its opacity for when it is shown again.
struct LayerState {
    bool visible = true;
    double opacity = 1.0; ///< 0..1
    bool operator==(const LayerState&) const = default;
};

using LayerStates = std::array<LayerState, map_layer_count>;
/// What map and layers panel begin with: all visible but the radio links, the world's picture thin under what is
/// measured.
LayerStates firstLayers();

/// A robot as the map needs it. `number` 1..9 chooses color and key.
struct MapRobot {
    QString name;
    int number = 1;
    /// Drawn from x, y and yaw; z is said in the tooltip only.
    Pose base_in_map;
    bool stale = false;   ///< nobody vouches for the pose any more
    bool station = false; ///< a base station: it stands, and looks nowhere
    bool operator==(const MapRobot&) const = default;
};

/// A robot with all that belongs to it.
struct RobotOnMap {
    MapRobot robot;
    /// Since the spawn or the last clearTraces; poses that nobody vouches for are not in it.
    Trail trail;
    /// Where the behavior flies to now; nothing while it has no goal.
    std::optional<Vec3> goal_in_map_m;
    std::vector<Vec3> hits_in_map_m; ///< of its newest scan; NaN where a beam hit nothing
};

/// The mission area while and after it is drawn.
struct AreaOnMap {
    /// Nothing: not drawn yet. Never an empty rectangle.
    std::optional<Rectangle> area_in_map;
    QString summary;                  ///< "9 lanes · 6 min 12 s", set by who plans
    std::vector<Vec2> lanes_in_map_m; ///< planned or flown path, in order
    bool editing = false;             ///< the area tool is in hand: handles are drawn
    std::optional<AreaGrip> hot_grip; ///< under the cursor
};

/// The things of the world, and what is being done with them.
struct ObjectsOnMap {
    std::vector<MapObject> objects; ///< in the order in which they are drawn
    QString selected;               ///< empty for none
    QString held;                   ///< dragged to `held_to_m`, and still where it was
    Vec2 held_to_m = Vec2::Zero();
    std::optional<MapObject> ghost; ///< would come into the world here
};

/// Metres in the map frame throughout. The painters only read it, so one copy serves map, overlay and labels of a
/// frame.
struct MapContent {
    /// Nothing on a real server, which does not say how large its world is.
    std::optional<Rectangle> world_in_map;
    QString world_name;
    QImage background; ///< drawn over the world, if any; row 0 = highest y
    Rectangle background_in_map;
    std::vector<protocol::StartPose> start_poses;
    std::optional<std::size_t> hot_start_pose; ///< under the cursor or chosen by keys
    AreaOnMap area;
    std::map<QString, RobotOnMap> robots;
    /// Empty for nobody; may name a robot that has no pose yet.
    QString selected_robot;
    /// Of all robots, in order of time.
    std::vector<agent::MapMark> marks;
    ObjectsOnMap objects;
    /// Between robots by name; those that are not on the map are not drawn.
    std::vector<RadioLink> radio_links;
    LayerStates layers = firstLayers();

    const LayerState& layer(MapLayer which) const { return layers[static_cast<std::size_t>(which)]; }
};

} // namespace usar::widgets
