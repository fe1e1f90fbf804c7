// Dock view of a robot's camera: the picture, its age, and the controls and gestures that zoom and turn the camera.
#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QWidget>

#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/sheet.h"

class QAction;

namespace usar::widgets {

/// Dragging moves the scene with the mouse, as on a map; the arrow keys turn the camera, the wheel zooms. A stale
/// picture is drawn faded. GUI thread.
class CameraCanvas : public Instrument {
    Q_OBJECT
public:
    explicit CameraCanvas(QWidget* parent = nullptr);

    /// Shows this picture as fresh; a null image shows an empty ground.
    void setPicture(const QImage& picture);
    /// The picture as last set; null if there is none.
    const QImage& picture() const { return picture_; }
    /// Rectangle of the picture in pixels of this widget; keeps the aspect ratio.
    QRect pictureRect() const;
    /// Lines of text in a corner; with a cross at the center they are the overlay, which is no part of picture().
    void setNote(const QString& note);
    const QString& note() const { return note_; }
    void setOverlayShown(bool shown);
    QSize sizeHint() const override { return {320, 240}; }
    QSize minimumSizeHint() const override { return {120, 90}; }

signals:
    /// How far the camera should turn to the right and up, as fractions of the picture's width.
    void turned(double right, double up);
    /// Notches of the wheel; positive is closer.
    void zoomed(double notches);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void paintOverlay(QPainter& painter) const;

    QImage picture_;
    QString note_;
    bool overlay_shown_ = true;
    /// Place of the mouse at the last step of the drag, in pixels.
    QPoint grabbed_;
    bool grabbing_ = false;
};

/// Horizontal angles of view of the shown camera. The camera cannot zoom if `largest_rad` <= `smallest_rad`.
struct CameraZoom {
    double now_rad = 1.396;
    double smallest_rad = 0.349;
    double largest_rad = 2.094;
};

/// Pictures come in by setters, wishes go out by signals. While hidden or covered it wants no pictures and says so by
/// wantsPicturesChanged. GUI thread.
class CameraView : public QWidget {
    Q_OBJECT
public:
    explicit CameraView(QWidget* parent = nullptr);

    /// Shows a new picture, which counts as fresh for two seconds; `frames_per_s` is only displayed.
    void setPicture(const QImage& picture, double frames_per_s);
    /// The newest picture; null while the view is empty.
    const QImage& picture() const { return canvas_->picture(); }
    /// Number of pictures taken since construction.
    int pictureCount() const { return pictures_; }
    /// Shows the robot's name with the shown camera; with more than one camera they are offered in a list. Emits
    /// nothing.
    void setSource(const QString& robot, const QStringList& cameras, const QString& shown);
    /// Shows the current angle and the limits of the camera; emits nothing.
    void setZoom(const CameraZoom& zoom);
    /// Replaces the picture by a sheet that says what is missing and what to do, with a button for `action` if given.
    /// The next picture removes it.
    void setEmpty(const QString& title, const QString& hint, QAction* action = nullptr);
    /// True while there is no picture.
    bool isEmpty() const { return picture().isNull(); }
    /// Adds these actions as tool buttons to the row of controls, in this order.
    void setActions(const QList<QAction*>& actions);
    /// Shows or hides the overlay of the picture; it is shown at first.
    void setOverlayShown(bool shown) { canvas_->setOverlayShown(shown); }
    /// Set to false while another tab covers the dock: Qt sends no hide event then.
    void setUncovered(bool uncovered) {
        uncovered_ = uncovered;
        watchedOrNot();
    }
    /// True while the view is shown and not covered.
    bool wantsPictures() const { return uncovered_ && isVisible(); }
    QSize sizeHint() const override { return {340, 330}; }

signals:
    /// The user wants this horizontal angle of view; it is within the limits of setZoom.
    void zoomRequested(double field_of_view_rad);
    /// How far the camera should turn to the right and up.
    void turnRequested(double right_rad, double up_rad);
    /// The user chose another camera of this robot.
    void cameraChosen(const QString& name);
    /// The view was shown, hidden, covered or uncovered.
    void wantsPicturesChanged(bool wants);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeControls();
    /// Updates the age of the picture and fades it when it is old.
    void showAge();
    void showNote();
    /// Runs the age timer only while the view can be seen, and emits wantsPicturesChanged.
    void watchedOrNot();
    /// Emits zoomRequested, clamped to the limits, if it differs from the current angle.
    void askZoom(double field_of_view_rad);

    CameraCanvas* canvas_ = new CameraCanvas(this);
    EmptyState* empty_ = new EmptyState(canvas_);
    QLabel* source_ = new QLabel(this);
    QLabel* freshness_ = mutedLabel({}, this);
    QComboBox* cameras_ = new QComboBox(this);
    QSlider* slider_ = new QSlider(Qt::Horizontal, this);
    QLabel* angle_ = new QLabel(this);
    QHBoxLayout* controls_;
    QTimer age_timer_;
    QElapsedTimer age_;
    CameraZoom zoom_;
    /// Rate of the pictures, as last set; only displayed.
    double frames_per_s_ = 0.0;
    int pictures_ = 0;
    bool uncovered_ = true;
};

} // namespace usar::widgets
