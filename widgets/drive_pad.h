// A stick on the screen: held by the mouse, a finger or the arrow keys, and back in the middle as soon as it is let go.
#pragma once

#include <QPointF>
#include <QWidget>

namespace usar::widgets {

/// Both: a round pad. Across and Upright: a slider that springs back.
enum class PadShape { Both, Across, Upright };

/// Values are shares -1..1, right and up positive. A dot shows where the stick is, a ring what is on its way to the
/// robot. Losing the focus, being hidden or disabled lets go. GUI thread.
class DrivePad : public QWidget {
    Q_OBJECT
public:
    explicit DrivePad(PadShape shape, QWidget* parent = nullptr);

    QPointF value() const { return value_; }
    bool held() const { return held_; }
    /// What another hand asks, and what is sent, while this one is not held.
    void setShown(const QPointF& asked, const QPointF& sent);
    /// The keys that do the same, at its edges: up, down, left, right; an empty one is not drawn.
    void setKeys(const QStringList& keys);
    /// As if the mouse had been let go.
    void letGo();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// With the middle when it is let go.
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
    QRectF travel() const;
    QPointF toScreen(const QPointF& value) const;
    void hold(const QPointF& at_px);
    void put(const QPointF& value, bool held);
    void takeArrow(int key, bool down);
    void paintGround(QPainter& painter) const;
    void paintKeys(QPainter& painter) const;
    void paintStick(QPainter& painter) const;

    PadShape shape_;
    QPointF value_;
    QPointF asked_;
    QPointF sent_;
    QStringList keys_;
    int arrows_ = 0; ///< bits of those that are down
    bool held_ = false;
};

} // namespace usar::widgets
