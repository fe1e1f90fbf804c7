// Shows a camera picture as large as its aspect ratio allows, and takes the gestures that turn and zoom the camera.
#pragma once

#include <QImage>

#include "widgets/style/sheet.h"

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
    QImage picture_;
    QPoint grabbed_;
    bool grabbing_ = false;
};

} // namespace usar::widgets
