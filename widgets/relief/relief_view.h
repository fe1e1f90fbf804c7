// The dock "3D view": the height map as a surface with trails, robots and marks, seen by a camera that orbits.
#pragma once

#include <map>

#include <QComboBox>
#include <QJsonObject>
#include <QToolButton>

#include "widgets/map/map_view.h"
#include "widgets/relief/relief_canvas.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// Shows what the map shows: the same tiles, colors, robots, areas and marks, where their layers are visible there. It
/// looks at the map twenty times a second; while it is hidden or covered, it does nothing. GUI thread; the map must
/// outlive it.
class ReliefView : public QWidget {
    Q_OBJECT
public:
    explicit ReliefView(MapView& map, QWidget* parent = nullptr);

    ReliefCanvas& canvas() { return *canvas_; }
    const ReliefRenderer& renderer() const { return *renderer_; }
    EmptyState* emptyState() const { return empty_state_; } ///< shown while there are no heights
    bool following() const { return follow_->isChecked(); } ///< the selected robot stays in the middle
    /// Shows it as a button.
    void setSaveAction(QAction* save);
    /// Camera, exaggeration and following, for settings and layouts: {"yaw_deg": 135, …}.
    QJsonObject state() const;
    /// What is missing or nonsense stays as it is; but without "target_m" the camera shows all.
    void setState(const QJsonObject& state);
    /// Set to false while another tab covers the dock: Qt sends no hide event then.
    void setUncovered(bool uncovered);
    /// True if there is a picture to be seen.
    bool hasPicture() const { return isVisible() && canvas_->frame(); }

signals:
    void hasPictureChanged();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeControls();
    void watchedOrNot();
    /// Emits hasPictureChanged if that is so.
    void tellPicture();
    /// Asks for a frame if what is to be seen has changed.
    void look();
    void askForFrame();
    ReliefThings thingsNow();
    /// The points of a trail, which are copied only if they are others than the last time.
    SharedPoints pointsOf(const QString& robot, const Trail& trail);
    std::vector<ReliefCanvas::Label> labelsNow() const;
    void showProbe(const std::optional<Vec3>& point_in_map_m);

    MapView& map_;
    ReliefRenderer* renderer_ = new ReliefRenderer(this);
    ReliefCanvas* canvas_ = new ReliefCanvas(this);
    EmptyState* empty_state_ = new EmptyState(canvas_);
    QComboBox* exaggeration_ = new QComboBox(this);
    QToolButton* all_ = nullptr;
    QToolButton* follow_ = nullptr;
    QToolButton* save_ = nullptr;
    QTimer glance_; ///< runs while the view is seen
    bool heights_changed_ = true;
    bool uncovered_ = true;
    bool had_picture_ = false;
    ReliefThings asked_; ///< for the newest frame
    // What the renderer does not have yet:
    bool forgets_tiles_ = false;
    mapping::HeightTiles changed_;
    std::map<QString, SharedPoints> trail_points_; ///< by the robot's name
};

} // namespace usar::widgets
