// Shows a camera picture as large as its aspect ratio allows, and takes the gestures that turn and zoom the camera.
#pragma once

#include <QImage>
#include <QWidget>

namespace usar::widgets {

/// Dragging moves the scene with the mouse, as on a map; the arrow keys turn the camera, the wheel zooms. GUI thread.
class CameraCanvas : public QWidget {
    Q_OBJECT
public:
    explicit CameraCanvas(QWidget* parent = nullptr);

    /// Shows this picture as fresh; a null image shows an empty ground.
    void setPicture(const QImage& picture);
    /// The picture as last set; null if there is none.
    const QImage& picture() const { return picture_; }
    /// Draws the picture faded, because it may be out of date.
    void setStale(bool stale);
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
    bool stale_ = false;
};

} // namespace usar::widgets
