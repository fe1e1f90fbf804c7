// The map in the center of the window: world, start poses, robots, area, lanes and the scan preview as layers.
#pragma once

#include <functional>
#include <utility>

#include <QTimer>
#include <QWidget>

#include "widgets/map/ground_picture.h"
#include "widgets/map/height_layer.h"
#include "widgets/map/map_changes.h"
#include "widgets/map/map_gestures.h"
#include "widgets/map/trace_layer.h"
#include "widgets/models/pan_zoom.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// State comes in by setters, gestures go out by signals; it knows no session. What one cycle of a robot changes, scan
/// included, is painted once, and only where it looks different.
/// Keys when focused: arrows pan (with Shift farther), + and - zoom, N and Shift+N step through the start poses, Return
/// spawns there, Space asks first, Escape cancels a drag or leaves a tool, Delete asks to remove the selected object.
/// Lengths are in meters of the map frame. GUI thread.
class MapView : public QWidget {
    Q_OBJECT
public:
    explicit MapView(QWidget* parent = nullptr);

    // The world and its height map.
    /// Sets the extent and name of the world and what stands in it, and shows all of it.
    void setWorld(const Rectangle& extent_in_map, const QString& name, const SceneryPtr& scenery = {});
    void setBackground(const QImage& image, const Rectangle& image_in_map); ///< above the ground; row 0 = highest y
    void setStartPoses(const std::vector<protocol::StartPose>& poses);      ///< signals refer to them by index
    void clear(); ///< removes all but layers and tool, because the server has changed; a gesture in progress ends
    EmptyState* emptyState() const { return empty_state_; } ///< shown while there is no world, start pose or robot
    HeightLayer& heights() { return *heights_; }
    /// `names` tells the probe who has scanned a point; asked in paintEvent if there are several robots.
    void setScannedBy(const std::function<QStringList(const Vec2& point_in_map_m)>& names) { scanned_by_ = names; }
    void setAgeOf(const std::function<std::optional<Seconds>(const Vec2&)>& age) { age_of_ = age; } ///< of its height

    // The mission.
    void setArea(const std::optional<Rectangle>& area_in_map);
    /// The mission area; nullopt or, in the setter, an empty rectangle: none.
    const std::optional<Rectangle>& area() const { return content_.area.area_in_map; }
    /// "9 lanes · 6 min 12 s": shown after the size on the area's label.
    void setAreaSummary(const QString& summary) { put(content_.area.summary, summary); }
    void setLanes(const std::vector<Vec2>& points_in_map_m) { put(content_.area.lanes_in_map_m, points_in_map_m); }

    // Robots. A pose also extends the trail, unless it is stale.
    void setRobot(const MapRobot& robot); ///< adds it, or updates the one with this name
    /// Removes a robot with its paths, goal, hits, area and marks; if it was selected, selection and following end.
    void removeRobot(const QString& name);
    /// Goal of the behavior and end points of the newest scan (NaN: no hit). An unknown robot changes nothing.
    void setGoal(const QString& robot, const std::optional<Vec3>& goal_in_map_m);
    void setLaserHits(const QString& robot, const std::vector<Vec3>& hits_in_map_m);
    void setCorrectedPath(const QString& robot, const SharedPath& path_in_map_m);  ///< null: its map is not corrected
    void addMarks(const QString& robot, const std::vector<agent::MapMark>& marks); ///< of one not on the map yet, too
    void clearMarks(const QString& robot);
    /// Area of its newest behavior, shown while another robot is selected; empty: none. As setGoal for unknown robots.
    void setRobotArea(const QString& robot, const Rectangle& area_in_map);
    void setRadioLinks(const std::vector<RadioLink>& links);
    void selectRobot(const QString& name); ///< draws the ring around it; empty: selects nobody and ends following

    // Objects of the world.
    /// Replaces all objects; the last one is on top. Selection and drag end if their object is missing.
    void setObjects(const std::vector<MapObject>& objects);
    void selectObject(const QString& name) { put(content_.objects.selected, name); } ///< empty: none
    /// Sets the object that the Place tool and drags out of the palette show under the cursor; nullopt: none.
    void setGhost(const std::optional<MapObject>& ghost) { gestures_.setGhost(ghost); }
    void addTraceMark(const Vec2& point_in_map_m, const QColor& color); ///< left by a robot while TRACE was on
    void clearTraceMarks();
    const TraceLayer& traces() const { return traces_; }

    // The view.
    void setLayer(MapLayer layer, const LayerState& state);
    const LayerState& layer(MapLayer layer) const { return content_.layer(layer); }
    MapGestures& gestures() { return gestures_; } ///< report what the user does on the map with the mouse
    /// Cancels a drag in progress; the gestures emit toolChanged if the tool changed.
    void setTool(MapTool tool) { gestures_.setTool(tool); }
    MapTool tool() const { return gestures_.tool(); }
    void setOrientation(MapOrientation orientation); ///< rotates the picture by a quarter turn and fits it again
    const MapTransform& transform() const { return transform_; }
    void setTransform(const MapTransform& transform); ///< center and scale only; the rest is the view's own
    const MapContent& content() const { return content_; }
    bool following() const { return following_; }
    QSize sizeHint() const override { return {800, 600}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

public slots:
    /// Shows the mission with the selected robot or a place that is wanted, clear of the legends; else the world.
    void fit(const std::optional<usar::Vec2>& wanted_in_map_m = {});
    /// Shows the whole world, or the start poses with 20 m around them if its extent is not known.
    void fitWorld();
    void zoomIn() { zoomAt(QRectF(rect()).center(), zoom_step::closer); }
    void zoomOut() { zoomAt(QRectF(rect()).center(), zoom_step::farther); }
    /// Keeps the selected robot in the middle until the user pans. Has no effect without a selected robot on the map.
    void setFollowing(bool following);

signals:
    void spawnRequested(int start_pose);                     ///< double-click or Return on a start pose; its index
    void startPoseClicked(int start_pose, const QPoint& at); ///< or Space; `at` is global, beside the diamond
    void objectRemovalRequested(const QString& name);
    void followingChanged(bool following);
    void escapeUsed(); ///< Escape has canceled a drag or left a tool

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    template <class Part, class Value>
    void put(Part& part, const Value& value) { // Repaints if this changes the content.
        if (std::exchange(part, value) != value)
            update();
    }
    void panBy(const QPointF& by_px);
    void zoomAt(const QPointF& at_px, double factor);
    bool actByKey(const QKeyEvent& event);
    void walkStartPoses(int by);
    void askAbout(std::size_t start_pose); ///< emits startPoseClicked
    void showContent();                    ///< paints soon, and shows the sheet if there is nothing
    void paintSoon();                      ///< with what comes within the next moment
    void paintChanges();
    MapOverlay overlay() const;
    void moved();       ///< repaints after the view moved
    void showWayBack(); ///< a button, if nothing of the world is in sight

    MapContent content_;
    MapTransform transform_;
    MapGestures gestures_{*this, content_, transform_};
    HeightLayer* heights_ = new HeightLayer(this);
    GroundPicture ground_;
    MapChanges changes_;
    QRegion late_px_; ///< changed while a part was about to be painted
    TraceLayer traces_;
    std::function<QStringList(const Vec2&)> scanned_by_;
    std::function<std::optional<Seconds>(const Vec2&)> age_of_;
    QTimer soon_;
    EmptyState* empty_state_ = new EmptyState(this);
    QPushButton* way_back_ = new QPushButton(tr("Back to the map"), this);
    bool following_ = false;
    enum class Shown { World, Mission, Chosen } shown_ = Shown::World; ///< a resized view shows it, or else its center
    std::optional<Vec2> wanted_m_;                                     ///< the place that is shown with the mission
};

} // namespace usar::widgets
