// The one map in the center: world, start poses, robots, area, lanes and the scan preview as layers.
#pragma once

#include <QWidget>

#include "core/mapping/coverage_path.h"
#include "widgets/height_layer.h"
#include "widgets/map_content.h"
#include "widgets/models/map_transform.h"
#include "widgets/trace_layer.h"

namespace usar::widgets {

class EmptyState;

/// What the left mouse button does on open ground. The middle button always pans. Place: a click brings a thing into
/// the world; Waypoint: it adds a way point of the selected thing.
enum class MapTool { Pan, Area, Place, Waypoint };

/// What a thing that is dragged out of the palette carries.
inline constexpr const char* object_mime = "application/x-usar-thing";

/// Values in by setters, gestures out by signals; it knows no session. Repaints are coalesced by Qt's update(). Keys
/// when focused: arrows pan, + and - zoom, N and Shift+N walk over the start poses, Return spawns there, Space asks
/// about it, Escape gives a drag or a tool up, Delete asks to remove the selected thing. Units are metres in the map
/// frame. GUI thread.
class MapView : public QWidget {
    Q_OBJECT
public:
    explicit MapView(QWidget* parent = nullptr);
    ~MapView() override;

    // The world.
    void setWorld(const Rectangle& extent_in_map, const QString& name);
    /// A picture of the world (row 0 = highest y), drawn under everything but the ground.
    void setBackground(const QImage& image, const Rectangle& image_in_map);
    void setStartPoses(const std::vector<protocol::StartPose>& poses);
    /// Forgets world, start poses, robots, heights, marks and area: another server, another truth.
    void clear();
    /// The sheet that is shown while there is neither world nor start pose nor robot.
    EmptyState* emptyState() const { return empty_state_; }

    // The height map.
    void clearHeights(double cell_size_m);
    /// What a session hands out; tiles replace tiles, and a new range recolors everything at once.
    void takeTiles(const std::vector<std::shared_ptr<const mapping::HeightTile>>& tiles,
                   const std::optional<mapping::HeightRange>& range);
    void setColorMap(mapping::ColorMap color_map);
    HeightLayer& heights() { return *heights_; }

    // The mission.
    /// Shown at once; no signal. An empty rectangle is no area.
    void setArea(const std::optional<Rectangle>& area_in_map);
    const std::optional<Rectangle>& area() const { return content_.area.area_in_map; }
    /// "9 lanes · 6 min 12 s": behind the size on the area's label.
    void setAreaSummary(const QString& summary);
    void setLanes(const std::vector<Vec2>& points_in_map_m);
    void setLanes(const mapping::CoveragePlan& plan);

    // Robots. A pose also extends the trail.
    void setRobot(const MapRobot& robot);
    /// With trail, goal and hits; ends the selection and following if it was the one.
    void removeRobot(const QString& name);
    void setGoal(const QString& robot, const std::optional<Vec3>& goal_in_map_m);
    /// Of its newest scan, map frame; NaN where a beam hit nothing.
    void setLaserHits(const QString& robot, const std::vector<Vec3>& hits_in_map_m);
    void addMark(const agent::MapMark& mark);
    void clearMarks();
    /// All there are.
    void setRadioLinks(const std::vector<RadioLink>& links);
    /// Trails, marks, laser hits and goals of the last mission.
    void clearTraces();
    /// Draws the ring; an empty name selects nobody and ends following.
    void selectRobot(const QString& name);

    // Things of the world.
    /// All there are, the last one on top.
    void setObjects(const std::vector<MapObject>& objects);
    /// Silent; an empty name selects none.
    void selectObject(const QString& name);
    /// What the Place tool and drags out of the palette show under the cursor.
    void setGhost(const std::optional<MapObject>& ghost);
    void addTraceMark(const Vec2& point_in_map_m, const QColor& color);
    void clearTraceMarks();
    const TraceLayer& traces() const { return traces_; }

    // The view.
    void setLayer(MapLayer layer, const LayerState& state);
    const LayerState& layer(MapLayer layer) const { return content_.layer(layer); }
    /// Gives up a drag that is under way, and tells when the tool is another.
    void setTool(MapTool tool);
    MapTool tool() const { return tool_; }
    /// Turns the picture a quarter and fits it anew.
    void setOrientation(MapOrientation orientation);
    const MapTransform& transform() const { return transform_; }
    /// Center and scale only: viewport and orientation are the view's own.
    void setTransform(const MapTransform& transform);
    const MapContent& content() const { return content_; }
    bool following() const { return following_; }
    QSize sizeHint() const override { return {800, 600}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

public slots:
    /// Shows the mission (area and heights) where there is one, else the world.
    void fit();
    /// All of the world, or 20 m around the start poses where its extent is not known.
    void fitWorld();
    void zoomIn();
    void zoomOut();
    /// Keeps the selected robot in the middle until the person pans.
    void setFollowing(bool following);

signals:
    /// Double-click or Return on a start pose.
    void spawnRequested(int start_pose);
    /// One click or Space; `at` is in global coordinates, beside the diamond.
    void startPoseClicked(int start_pose, const QPoint& at);
    /// The view has selected it already.
    void robotClicked(const QString& name);
    /// While the area is dragged, many times; and once when it is let go.
    void areaEdited(const usar::Rectangle& area_in_map);
    void areaChanged(const usar::Rectangle& area_in_map);
    /// A drawn area of no size, or wholly outside the world: a sentence with the mend. The area stays what it was.
    void areaRefused(const QString& reason);
    /// A thing shall come here; `again`: and another one after it.
    void placeRequested(const usar::Vec2& point_in_map_m, bool again);
    void waypointAdded(const usar::Vec2& point_in_map_m);
    /// The view has selected it already; empty for none.
    void objectClicked(const QString& name);
    /// Dragged there with its center; it is where it was until `setObjects` says otherwise.
    void objectMoved(const QString& name, const usar::Vec2& center_in_map_m);
    void objectRemovalRequested(const QString& name);
    /// The ground under the cursor.
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
    std::optional<std::size_t> startPoseAt(const QPointF& point_px) const;
    QString robotAt(const QPointF& point_px) const;
    QString objectAt(const QPointF& point_px) const;
    void hover(const QPointF& point_px);
    void click(const QPointF& point_px, Qt::KeyboardModifiers modifiers);
    bool clickWithTool(const QPointF& point_px, Qt::KeyboardModifiers modifiers);
    void clickObject(const QPointF& point_px);
    bool beginObjectDrag(const QPointF& point_px);
    void dragObject(const QPointF& point_px);
    void finishObjectDrag();
    void showGhost(const std::optional<QPointF>& at_px);
    QString objectToolTip(const QPointF& point_px) const;
    void panBy(const QPointF& by_px);
    void beginAreaGesture(const QPointF& point_px);
    void dragArea(const QPointF& point_px);
    void finishAreaGesture(Gesture gesture, const QPointF& point_px);
    void restoreArea(); ///< as if the gesture had not begun
    void cancelGesture();
    void walkStartPoses(int by);
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
    bool view_touched_ = false; ///< by the person; until then resizing fits again
    Gesture gesture_ = Gesture::None;
    QPointF pressed_px_;
    QPointF last_px_;
    Vec2 pressed_m_ = Vec2::Zero();
    AreaGrip held_grip_;
    std::optional<Rectangle> area_before_;
    std::optional<MapObject> ghost_; ///< wherever it is
    bool dragged_in_ = false;        ///< out of the palette, over the map
    Vec2 held_from_m_ = Vec2::Zero();
    std::optional<QPointF> cursor_px_;
};

} // namespace usar::widgets
