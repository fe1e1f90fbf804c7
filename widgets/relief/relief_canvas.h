// The picture of the 3D view, and what mouse and keys do in it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QColor>
#include <QTimer>
#include <QWidget>

#include "widgets/relief/relief_renderer.h"

namespace usar::widgets {

/// Shows the newest frame, and asks for another one when the camera should move. The mouse: left drag orbits; right or
/// middle drag, or with Shift, pans; the wheel zooms toward the pointer; a double-click centers. Keys when focused:
/// arrows orbit, with Shift they pan; + and - zoom; Home shows all; N turns y up; T looks from above. Until the mouse
/// moves over it, the focused view reads the place in its middle. GUI thread.
class ReliefCanvas : public QWidget {
    Q_OBJECT
public:
    explicit ReliefCanvas(QWidget* parent = nullptr);

    /// With nullptr, nothing is seen any more.
    void setFrame(const std::shared_ptr<const ReliefFrame>& frame);
    const std::shared_ptr<const ReliefFrame>& frame() const { return frame_; } ///< nullptr before the first
    /// The wanted camera; that of the frame may still be an earlier one.
    const mapping::OrbitCamera& camera() const { return camera_; }
    void setCamera(const mapping::OrbitCamera& camera);
    void setExaggeration(double exaggeration);
    double exaggeration() const { return exaggeration_; }
    /// True until the user moves the camera: it shows all of the surface, however that grows.
    bool showsAll() const { return shows_all_; }
    void showAll();
    /// Moves the target there, and leaves direction and distance.
    void lookAt(const Vec3& point_in_map_m);
    /// With true, the wheel zooms toward the target instead of the pointer, as for a target that is followed.
    void keepTarget(bool on) { keeps_target_ = on; }

    /// A name beside a place.
    struct Label {
        QString text;
        Vec3 place_in_map_m;
        bool operator==(const Label&) const = default;
    };
    void setLabels(const std::vector<Label>& labels);
    const std::vector<Label>& labels() const { return labels_; }
    /// Size of the picture that should be asked for: that of the widget, or less while the camera moves if whole
    /// pictures take too long.
    QSize wantedSize_px() const;
    const QString& probe() const { return probe_; }
    /// What is seen, with names and axes, in the size of the newest frame; null before the first.
    QImage picture() const;
    /// The place of the surface or mark that is seen there; nullopt for the background.
    std::optional<Vec3> pick(const QPointF& at_px) const;
    QSize sizeHint() const override { return {560, 320}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

signals:
    void frameWanted(); ///< camera or size are others
    void movedByUser(); ///< to another target: by panning, by centering, or by the key that shows all
    /// The mouse is over this point, or without it the middle of the focused view; nullopt: over none.
    void pointed(const std::optional<usar::Vec3>& point_in_map_m);

public slots:
    /// "x 31.2   y −8.0   z 4.31 m", shown in a corner; empty: none.
    void setProbe(const QString& text);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    mapping::ReliefProjection projection() const; ///< of the wanted camera, in pixels of the widget
    void moveTo(const mapping::OrbitCamera& camera);
    void orbit(double right_px, double down_px);
    QSize wholeSize_px() const; ///< one pixel of the picture for each of the screen
    void pan(const QPointF& from_px, const QPointF& to_px);
    void panOverGround(const QPointF& way);                ///< to the right and ahead, by one step of the keys
    void zoom(const Vec3& toward_in_map_m, double factor); ///< the point stays where it is in the picture
    bool actByKey(int key, bool shift);
    bool readsMiddle() const { return hasFocus() && !pointer_px_; }
    void tellPointed();
    void paintFrame(QPainter& painter) const; ///< in pixels of the widget
    void paintLabels(QPainter& painter) const;
    void paintMiddle(QPainter& painter) const; ///< the cross over the place that is read
    void paintAxes(QPainter& painter) const;

    std::shared_ptr<const ReliefFrame> frame_;
    mapping::OrbitCamera camera_;
    double exaggeration_ = 1.0;
    bool shows_all_ = true;
    std::vector<Label> labels_;
    QString probe_;
    bool keeps_target_ = false;
    std::optional<QPointF> pointer_px_; ///< where the mouse was last without a button; empty while it is elsewhere
    std::optional<QPointF> grabbed_px_;
    double grabbed_height_m_ = 0.0;
    double whole_took_ms_ = 0.0; ///< the newest picture in full size
    QTimer rest_;                ///< runs while the camera moves
};

} // namespace usar::widgets
