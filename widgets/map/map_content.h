// Everything that the map shows, as plain values: set by MapView and its gestures, read by its painters.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <QImage>
#include <QString>

#include "core/agent/published.h"
#include "core/base/scenery.h"
#include "core/protocol/info/game_info.h"
#include "widgets/map/robot_on_map.h"
#include "widgets/models/map/area_grip.h"
#include "widgets/models/map/map_object.h"
#include "widgets/models/map/measured_line.h"
#include "widgets/models/radio_links.h"

namespace usar::widgets {

/// Layers in painting order, lowest first.
enum class MapLayer {
    World,
    Grid,
    Heights,
    Contours,
    Area,
    Lanes,
    Trails,
    Corrected,
    Traces,
    Marks,
    Objects,
    StartPoses,
    Laser,
    Goals,
    Radio,
    Robots
};
inline constexpr std::size_t map_layer_count = 16;
/// "Height map": the layer's name in menus and in the layers panel.
QString layerName(MapLayer layer);

/// State of a layer. A hidden layer keeps its opacity for when it is shown again.
struct LayerState {
    /// The user wants to see it.
    bool visible = true;
    double opacity = 1.0; ///< 0..1
    bool operator==(const LayerState&) const = default;
};

using LayerStates = std::array<LayerState, map_layer_count>;
/// Initial state of map and layers panel: everything visible except contours and radio links; the world is faint, so
/// that it stays in the background of the measurements.
LayerStates firstLayers();

/// The mission area while it is drawn and afterwards.
struct AreaOnMap {
    /// nullopt before the first drawing; never an empty rectangle.
    std::optional<Rectangle> area_in_map;
    QString summary;                  ///< "9 lanes · 6 min 12 s", from the planner
    std::vector<Vec2> lanes_in_map_m; ///< planned or flown path, in order
    bool editing = false;             ///< the area tool is active: handles are drawn
    std::optional<AreaGrip> hot_grip; ///< the handle under the cursor
};

/// The objects of the world, and the selection, drag or placement in progress.
struct ObjectsOnMap {
    std::vector<MapObject> objects; ///< in drawing order
    QString selected;               ///< name; empty: none
    QString held;                   ///< name of the object that is being dragged to `held_to_m`; empty: none
    Vec2 held_to_m = Vec2::Zero();  ///< meters in the map frame; place of its center
    std::optional<MapObject> ghost; ///< preview of an object that a click or drop would place here
};

/// All lengths are in meters of the map frame. Painters only read this, so map, overlay and labels of a frame share one
/// copy.
struct MapContent {
    /// Unknown (nullopt) on a real server, which does not tell how large its world is.
    std::optional<Rectangle> world_in_map;
    /// Name of the world, drawn above its frame.
    QString world_name;
    QImage background; ///< picture of the world, null for none; row 0 = highest y
    /// The rectangle that `background` covers.
    Rectangle background_in_map;
    SceneryPtr scenery; ///< what stands in the world; nullptr: unknown
    std::vector<protocol::StartPose> start_poses;
    std::optional<std::size_t> hot_start_pose; ///< index of the one under the cursor or chosen by keys
    std::optional<Pose> spawn_draft_in_map;    ///< where the user wants to spawn a robot apart from the start poses
    std::optional<MeasuredLine> measured;      ///< what the measuring tool has drawn
    AreaOnMap area;
    /// Robots and base stations, by name.
    std::map<QString, RobotOnMap> robots;
    QString selected_robot; ///< name; empty: none. May have no pose yet
    /// Marks of all robots by the robot's name, each in order of time. May name robots that have no pose yet.
    std::map<QString, std::vector<agent::MapMark>> marks;
    ObjectsOnMap objects;
    /// Links between robots by name; links to robots that are not on the map are not drawn.
    std::vector<RadioLink> radio_links;
    LayerStates layers = firstLayers();

    const LayerState& layer(MapLayer which) const { return layers[static_cast<std::size_t>(which)]; }
    /// True if there is neither a world nor a start pose nor a robot.
    bool empty() const { return !world_in_map && start_poses.empty() && robots.empty(); }
    /// Extent of the world, or of the start poses with 20 m around them if it is not known; empty without both.
    Rectangle groundInMap() const;
    /// What the mission is about: the scan (empty: none), the area, the selected robot with where it began and where it
    /// is going. Empty without scan and area.
    Rectangle missionInMap(const Rectangle& scan_in_map) const;
    /// Mission, ground and all robots; nullopt if there is nothing. A single point has no size.
    std::optional<Rectangle> everythingInMap(const Rectangle& scan_in_map) const;
    /// True for a robot that others than the selected one are dimmed beside: all robots while none is selected.
    bool bright(const QString& robot) const { return selected_robot.isEmpty() || robot == selected_robot; }
    /// Removes everything that comes from the server; layers and the tool's handles stay.
    void forgetServer();

    /// Adds a robot, or updates the one with the same name; a pose that is not stale extends its trail.
    void takeRobot(const MapRobot& robot);
    /// The selected robot; nullptr if none is selected or it is not on the map.
    const MapRobot* selectedRobot() const;
    /// Removes and deselects what is no longer among them.
    void setObjects(const std::vector<MapObject>& all);
    /// The object with this name; nullptr if there is none. Valid until the next setObjects.
    MapObject* object(const QString& name);
    const MapObject* object(const QString& name) const;
    /// Where a SpawnChoice spawns: the start pose of this index, or the draft for SpawnChoice::at_draft; nullopt: gone.
    std::optional<Pose> startOf(int start_pose) const;
    /// Moves the highlight by `by` start poses, wrapping around at both ends; to the first (or last) one if none was
    /// highlighted. Returns the highlighted start pose, or nullptr if there are none.
    const protocol::StartPose* stepStartPose(int by);
};

} // namespace usar::widgets
