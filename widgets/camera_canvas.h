// The picture of a camera, as large as its shape allows, and the gestures that turn and zoom the camera.
#pragma once

#include <QImage>
#include <QWidget>

namespace usar::widgets {

/// Dragging takes the scene along, as on a map; arrow keys turn, the wheel zooms. GUI thread.
class CameraCanvas : public QWidget {
    Q_OBJECT
public:
    explicit CameraCanvas(QWidget* parent = nullptr);

    void setPicture(const QImage& picture);
    const QImage& picture() const { return picture_; }
    /// Drawn grey: nobody vouches for it any more.
    void setStale(bool stale);
    /// Where the picture is on this widget; keeps its shape.
    QRect pictureRect() const;
    QSize sizeHint() const override { return {320, 240}; }
    QSize minimumSizeHint() const override { return {120, 90}; }

signals:
    /// In widths of the picture: how far the camera is to look to the right and up.
    void turned(double right, double up);
    /// Notches, positive is closer.
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
