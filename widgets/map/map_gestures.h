// Mouse handling of the map: the active tool, the gesture in progress, and the user's requests.
#pragma once

#include <QDropEvent>
#include <QMouseEvent>
#include <QWidget>

#include "widgets/map/map_hits.h"

namespace usar::widgets {

/// Action of the left mouse button on open ground. Place: a click places an object in the world. Waypoint: a click adds
/// a way point to the selected object. Robot: a press is the place of a robot to spawn, a drag from there its yaw. The
/// middle and right buttons always pan.
enum class MapTool { Pan, Area, Place, Waypoint, Robot, Measure };

/// MIME type of an object that is dragged out of the palette.
inline constexpr const char* object_mime = "application/x-usar-thing";

/// Takes all events of the mouse, and drags out of the palette, over a widget. During a drag, the content previews
/// its effect; the signals report the user's requests. Moving the ground is left to the owner. Sets the widget's cursor
/// and repaints it. GUI thread.
class MapGestures : public QObject {
    Q_OBJECT
public:
    /// All three belong to the owner and must outlive the gestures. The gestures change these parts of the content: the
    /// selection, the highlight under the cursor, the area, and the held and the previewed object.
    MapGestures(QWidget& widget, MapContent& content, const MapTransform& transform);

    MapTool tool() const { return tool_; }
    /// Cancels a gesture in progress; emits toolChanged if the tool changed.
    void setTool(MapTool tool);
    /// The object that the Place tool and drags out of the palette preview under the cursor; nullopt: none.
    void setGhost(const std::optional<MapObject>& ghost);

    /// Sets the pose of the robot to spawn, which is drawn like a start pose; nullopt: none. Emits nothing.
    void setDraft(const std::optional<Pose>& draft_in_map);

    /// True from a press until its release or cancel().
    bool inProgress() const { return gesture_ != Gesture::None; }
    /// Ends the gesture and undoes its changes.
    void cancel();
    /// Cancels the gesture, else leaves the tool, else takes away the robot to spawn; returns false if there is none of
    /// them.
    bool escape();
    /// Ends the gesture without undoing its changes, because the changed content no longer exists.
    void forget();
    /// Position of the cursor in pixels of the widget; nullopt if it is outside.
    const std::optional<QPointF>& cursor_px() const { return cursor_px_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The map should move by this much.
    void panned(const QPointF& by_px);
    void startPoseClicked(std::size_t start_pose);
    void spawnRequested(int start_pose);
    /// The robot is already selected in the content.
    void robotClicked(const QString& name);
    /// Many times during a drag, then areaChanged once at its end. Empty: a canceled drag has left no area.
    void areaEdited(const usar::Rectangle& area_in_map);
    void areaChanged(const usar::Rectangle& area_in_map);
    /// The drawn area has no size or is outside the world, so all stays as it was; `reason` includes the remedy.
    void areaRefused(const QString& reason);
    /// The user wants an object here; `again`: the tool should stay active for another one (Shift).
    void placeRequested(const usar::Vec2& point_in_map_m, bool again);
    void waypointAdded(const usar::Vec2& point_in_map_m);
    /// The user has placed a robot to spawn, or another than before; z is 0, because only the server knows the ground.
    void draftPlaced(const std::optional<usar::Pose>& before, const std::optional<usar::Pose>& after);
    void draftClicked();
    /// The object is already selected in the content; empty: none.
    void objectClicked(const QString& name);
    /// The object was dragged so that its center is here; the map shows it here until the next setObjects.
    void objectMoved(const QString& name, const usar::Vec2& center_in_map_m);
    /// The user wants to know what wrote the map here (Ctrl+click on the ground).
    void writerAsked(const usar::Vec2& point_in_map_m);
    /// A line, or with Shift a rectangle, was drawn with the tool Measure; it stays until the tool is left or draws
    /// another one.
    void lineMeasured(const usar::widgets::MeasuredLine& line);
    void toolChanged(usar::widgets::MapTool tool);

private:
    enum class Gesture { None, Pressed, Panning, DraggingArea, DraggingObject, PlacingRobot, Measuring };
    MapHits hits() const { return {content_, transform_}; }
    /// These two functions return false if the event is of another kind.
    bool takeMouse(QEvent* event);
    bool takeDrag(QEvent* event);
    void press(const QMouseEvent& event);
    void move(const QPointF& at_px, Qt::KeyboardModifiers modifiers);
    void release(const QMouseEvent& event);
    void doubleClick(const QMouseEvent& event);
    void leave();
    void dragIn(QDropEvent& event);
    void drop(QDropEvent& event);
    /// Starts a drag, because the pressed mouse has moved too far for a click.
    void beginDrag();
    /// Starts to drag the object where the mouse was pressed; returns false if there is none.
    bool beginObjectDrag();
    void dragArea(const QPointF& at_px);
    void finishAreaDrag(const QPointF& at_px);
    void restoreArea();
    void finishObjectDrag();
    /// Turns the robot that is being placed toward the cursor, once this is far enough from it to tell a direction.
    void turnDraft(const QPointF& at_px);
    void finishPlacing();
    void finishMeasuring();
    /// Updates what is highlighted under the cursor.
    void hover(const QPointF& at_px);
    void click(const QPointF& at_px, Qt::KeyboardModifiers modifiers);
    /// Handles a click of the tools Place and Waypoint; returns true if one of them is active.
    bool clickWithTool(const QPointF& at_px, Qt::KeyboardModifiers modifiers);
    /// Selects the object, or none if the name is empty.
    void clickObject(const QString& name);
    /// Shows the preview if a click or drop there would place an object; nullopt: cursor outside.
    void showGhost(const std::optional<QPointF>& at_px);

    void updateCursor();

    QWidget& widget_;
    MapContent& content_;
    const MapTransform& transform_;
    MapTool tool_ = MapTool::Pan;
    Gesture gesture_ = Gesture::None;
    std::optional<QPointF> cursor_px_;
    QPointF pressed_px_;
    Vec2 pressed_m_ = Vec2::Zero(); ///< ground point at `pressed_px_` when pressed, in the map frame
    QPointF last_px_;
    std::optional<AreaGrip> held_grip_;    ///< the part of the area that is dragged; nullopt: a new area is drawn
    std::optional<Rectangle> area_before_; ///< area before the drag
    std::optional<Pose> draft_before_;     ///< robot to spawn before the drag
    Vec2 held_from_m_ = Vec2::Zero();      ///< center of the held object before the drag
    std::optional<MapObject> ghost_;       ///< the object to preview, wherever the cursor is
    bool dragged_in_ = false;              ///< a drag out of the palette is over the widget
};

} // namespace usar::widgets
