// The map in the center of the window: world, start poses, robots, area, lanes and the scan preview as layers.
#pragma once

#include <QWidget>

#include "core/mapping/coverage_path.h"
#include "widgets/map/height_layer.h"
#include "widgets/map/map_content.h"
#include "widgets/map/trace_layer.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

class EmptyState;

/// Action of the left mouse button on open ground. Place: a click places an object in the world. Waypoint: a click adds
/// a way point to the selected object. The middle and right buttons always pan.
enum class MapTool { Pan, Area, Place, Waypoint };

/// MIME type of an object that is dragged out of the palette.
inline constexpr const char* object_mime = "application/x-usar-thing";

/// State comes in by setters, gestures go out by signals; it knows no session. Repaints are coalesced by Qt's update().
/// Keys when focused: arrows pan (with Shift farther), + and - zoom, N and Shift+N step through the start poses, Return
/// spawns there, Space asks first, Escape cancels a drag or leaves the tools Place and Waypoint, Delete asks to remove
/// the selected object. Lengths are in meters of the map frame. GUI thread.
class MapView : public QWidget {
    Q_OBJECT
public:
    explicit MapView(QWidget* parent = nullptr);
    ~MapView() override;

    // The world.
    /// Sets the extent and name of the world and shows all of it.
    void setWorld(const Rectangle& extent_in_map, const QString& name);
    /// Sets a picture of the world (row 0 = highest y), drawn directly above the ground.
    void setBackground(const QImage& image, const Rectangle& image_in_map);
    /// Replaces the start poses; signals refer to them by index.
    void setStartPoses(const std::vector<protocol::StartPose>& poses);
    /// Removes world, start poses, robots, heights, marks and area, because the server has changed. Layers and tool
    /// stay.
    void clear();
    /// The sheet that is shown while there is no world, start pose or robot.
    EmptyState* emptyState() const { return empty_state_; }

    // The height map.
    /// Removes all heights; later tiles have cells of this size, in meters.
    void clearHeights(double cell_size_m);
    /// Tiles and range as the session delivers them; a tile replaces the one with the same index, and a changed range
    /// recolors everything at once. nullopt leaves the range unchanged.
    void takeTiles(const std::vector<std::shared_ptr<const mapping::HeightTile>>& tiles,
                   const std::optional<mapping::HeightRange>& range);
    void setColorMap(mapping::ColorMap color_map);
    HeightLayer& heights() { return *heights_; }

    // The mission.
    /// Shown at once, without a signal. nullopt or an empty rectangle: no area.
    void setArea(const std::optional<Rectangle>& area_in_map);
    /// The mission area; nullopt: none. Never an empty rectangle.
    const std::optional<Rectangle>& area() const { return content_.area.area_in_map; }
    /// "9 lanes · 6 min 12 s": shown after the size on the area's label.
    void setAreaSummary(const QString& summary);
    /// The path that is drawn as lanes, in order.
    void setLanes(const std::vector<Vec2>& points_in_map_m);
    void setLanes(const mapping::CoveragePlan& plan);

    // Robots. A pose also extends the trail, unless it is stale.
    /// Adds the robot, or updates the one with the same name.
    void setRobot(const MapRobot& robot);
    /// Removes a robot with its trail, goal and hits; if it was selected, selection and following end.
    void removeRobot(const QString& name);
    /// The goal of the behavior; nullopt: none. An unknown robot changes nothing.
    void setGoal(const QString& robot, const std::optional<Vec3>& goal_in_map_m);
    /// End points of the newest scan; NaN for beams that hit nothing. An unknown robot changes nothing.
    void setLaserHits(const QString& robot, const std::vector<Vec3>& hits_in_map_m);
    void addMark(const agent::MapMark& mark);
    void clearMarks();
    /// Replaces all links.
    void setRadioLinks(const std::vector<RadioLink>& links);
    /// Removes the trails, marks, laser hits and goals of the last mission.
    void clearTraces();
    /// Draws the ring around that robot; an empty name selects nobody and ends following.
    void selectRobot(const QString& name);

    // Objects of the world.
    /// Replaces all objects; the last one is on top. Selection and drag end if their object is missing.
    void setObjects(const std::vector<MapObject>& objects);
    /// Emits nothing; an empty name: none.
    void selectObject(const QString& name);
    /// Sets the object that the Place tool and drags out of the palette show under the cursor; nullopt: none.
    void setGhost(const std::optional<MapObject>& ghost);
    /// Adds a mark that a robot left while TRACE was on.
    void addTraceMark(const Vec2& point_in_map_m, const QColor& color);
    void clearTraceMarks();
    const TraceLayer& traces() const { return traces_; }

    // The view.
    void setLayer(MapLayer layer, const LayerState& state);
    const LayerState& layer(MapLayer layer) const { return content_.layer(layer); }
    /// Cancels a drag in progress; emits toolChanged if the tool changed.
    void setTool(MapTool tool);
    MapTool tool() const { return tool_; }
    /// Rotates the picture by a quarter turn and fits it again.
    void setOrientation(MapOrientation orientation);
    const MapTransform& transform() const { return transform_; }
    /// Takes center and scale only; viewport and orientation are the view's own.
    void setTransform(const MapTransform& transform);
    const MapContent& content() const { return content_; }
    bool following() const { return following_; }
    QSize sizeHint() const override { return {800, 600}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

public slots:
    /// Shows the mission (area and heights) if there is one, else the world.
    void fit();
    /// Shows the whole world, or the start poses with 20 m around them if its extent is not known.
    void fitWorld();
    void zoomIn();
    void zoomOut();
    /// Keeps the selected robot in the middle until the user pans. Has no effect without a selected robot on the map.
    void setFollowing(bool following);

signals:
    /// Double-click or Return on a start pose; its index.
    void spawnRequested(int start_pose);
    /// Single click or Space; `at` is in global coordinates, beside the diamond.
    void startPoseClicked(int start_pose, const QPoint& at);
    /// The view has already selected it.
    void robotClicked(const QString& name);
    /// Emitted many times while the area is dragged, then areaChanged once when it is released. An empty rectangle
    /// means that a canceled drag left no area.
    void areaEdited(const usar::Rectangle& area_in_map);
    void areaChanged(const usar::Rectangle& area_in_map);
    /// The drawn area has no size or lies outside the world; `reason` is a sentence with the remedy. The area stays as
    /// it was.
    void areaRefused(const QString& reason);
    /// The user wants an object here; `again`: the tool should stay active for another one (Shift).
    void placeRequested(const usar::Vec2& point_in_map_m, bool again);
    void waypointAdded(const usar::Vec2& point_in_map_m);
    /// The view has already selected it; empty: none.
    void objectClicked(const QString& name);
    /// The object was dragged so that its center is here; the map shows it here until the next setObjects.
    void objectMoved(const QString& name, const usar::Vec2& center_in_map_m);
    /// The user wants to remove the selected object.
    void objectRemovalRequested(const QString& name);
    /// The ground under the cursor; nullopt if its height is unknown.
    void probed(const usar::Vec2& point_in_map_m, std::optional<usar::widgets::HeightProbe> height);
    void followingChanged(bool following);
    void toolChanged(usar::widgets::MapTool tool);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Gesture { None, Pressed, Panning, DrawingArea, DraggingGrip, DraggingObject };
    /// Index of the nearest start pose within reach of the cursor.
    std::optional<std::size_t> startPoseAt(const QPointF& point_px) const;
    QString robotAt(const QPointF& point_px) const;
    QString objectAt(const QPointF& point_px) const;
    /// Updates what is highlighted under the cursor.
    void hover(const QPointF& point_px);
    void click(const QPointF& point_px, Qt::KeyboardModifiers modifiers);
    /// Handles a click of the tools Place and Waypoint; returns true if one of them is active.
    bool clickWithTool(const QPointF& point_px, Qt::KeyboardModifiers modifiers);
    void clickObject(const QPointF& point_px);
    /// Starts to drag the object at that place; returns false if there is none.
    bool beginObjectDrag(const QPointF& point_px);
    void dragObject(const QPointF& point_px);
    void finishObjectDrag();
    /// Shows the preview at the cursor if a click or drop would place an object there; nullopt: cursor outside.
    void showGhost(const std::optional<QPointF>& at_px);
    QString objectToolTip(const QPointF& point_px) const;
    void panBy(const QPointF& by_px);
    void beginAreaGesture(const QPointF& point_px);
    void dragArea(const QPointF& point_px);
    void finishAreaGesture(Gesture gesture, const QPointF& point_px);
    void restoreArea(); ///< undoes the gesture
    void cancelGesture();
    void walkStartPoses(int by);
    /// Emits startPoseClicked.
    void askAbout(std::size_t start_pose);
    void updateEmptyState();
    void updateCursor();
    QString toolTipAt(const QPointF& point_px) const;

    MapContent content_;
    MapTransform transform_;
    HeightLayer* heights_;
    TraceLayer traces_;
    EmptyState* empty_state_;
    MapTool tool_ = MapTool::Pan;
    bool following_ = false;
    bool view_touched_ = false; ///< by the user; until then resizing fits again
    Gesture gesture_ = Gesture::None;
    QPointF pressed_px_;
    QPointF last_px_;
    Vec2 pressed_m_ = Vec2::Zero();
    AreaGrip held_grip_;
    /// Area before the gesture.
    std::optional<Rectangle> area_before_;
    std::optional<MapObject> ghost_; ///< the object to preview, wherever it is
    bool dragged_in_ = false;        ///< a drag out of the palette is over the map
    /// Center of the dragged object before the drag.
    Vec2 held_from_m_ = Vec2::Zero();
    std::optional<QPointF> cursor_px_;
};

} // namespace usar::widgets
