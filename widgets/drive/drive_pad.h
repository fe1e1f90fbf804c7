// On-screen stick, held with the mouse, a finger or the arrow keys; it springs back to the middle when released.
#pragma once

#include <QPointF>
#include <QWidget>

namespace usar::widgets {

/// Both: a round pad with two axes. Across and Upright: a slider that springs back.
enum class PadShape { Both, Across, Upright };

/// Values are shares -1..1, positive to the right and up. A dot shows where the stick is, a ring what is being sent to
/// the robot. Losing the focus, being hidden or being disabled releases it. GUI thread.
class DrivePad : public QWidget {
    Q_OBJECT
public:
    explicit DrivePad(PadShape shape, QWidget* parent = nullptr);

    /// The current position; zero when released.
    QPointF value() const { return value_; }
    /// True while the user holds the stick.
    bool held() const { return held_; }
    /// Sets what is shown while this pad is not held: the position that another input asks for, and the one that is
    /// sent to the robot.
    void setShown(const QPointF& asked, const QPointF& sent);
    /// Labels of the keys that do the same, drawn at the edges in the order up, down, left, right; an empty one is not
    /// drawn.
    void setKeys(const QStringList& keys);
    /// Releases the stick as if the mouse button had been released.
    void letGo();
    QSize sizeHint() const override { return sizeWith(176); }
    QSize minimumSizeHint() const override { return sizeWith(96); }

signals:
    /// The position changed; zero when the stick is released.
    void moved(const QPointF& value);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// Size of a round pad with this side, or of a slider of this length; in pixels.
    QSize sizeWith(int pad_px) const;
    /// Rectangle, in pixels, in which the middle of the knob can move.
    QRectF travel() const;
    /// Place of the knob's middle, in pixels, for a position of the stick.
    QPointF toScreen(const QPointF& value) const;
    /// Holds the stick at a place of the widget.
    void hold(const QPointF& at_px);
    /// Sets the position and emits moved if anything changed.
    void put(const QPointF& value, bool held);
    /// Holds the stick at the edge in the direction of the arrow keys that are down.
    void takeArrow(int key, bool down);
    void paintGround(QPainter& painter) const;
    void paintKeys(QPainter& painter) const;
    void paintStick(QPainter& painter) const;

    PadShape shape_;
    QPointF value_;
    /// Position that another input asks for; drawn as the dot while this pad is not held.
    QPointF asked_;
    /// Position that is sent to the robot; drawn as the ring.
    QPointF sent_;
    QStringList keys_;
    int arrows_ = 0; ///< bit set of the arrow keys that are down
    bool held_ = false;
};

} // namespace usar::widgets
