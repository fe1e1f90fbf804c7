// The sonars where they are mounted, seen from above.
#pragma once

#include "widgets/models/robot_instruments.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// What is ahead is at the top, the robot's left on the left. Each cone begins at its sonar's place, has its width and
/// bearing, reaches as far as the sonar can, and is filled up to what it measures; the range stands at its rim in
/// meters. Risk is shown by color and by a "!". The scale fits all cones. GUI thread.
class SonarRingView : public Instrument {
    Q_OBJECT
public:
    explicit SonarRingView(QWidget* parent = nullptr);

    /// Replaces the picture. A new one counts as fresh; the same again costs nothing.
    void setRing(const SonarRing& ring);
    QSize sizeHint() const override { return {280, 190}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Where things of the robot are on the screen.
    struct Frame {
        QPointF origin; ///< of the robot
        double scale = 1.0;
        /// The place of a point on the robot: x forward, y left, in meters.
        QPointF operator()(const Vec2& point_m) const { return origin + scale * QPointF(-point_m.y(), -point_m.x()); }
    };
    /// The frame in which all cones, the robot and the words at the rim fit into `room`.
    Frame frameFor(const QRectF& room) const;
    /// Paints the arcs of equal distance from the robot, with their distances.
    void paintArcs(QPainter& painter, const Frame& frame, const QRectF& room) const;
    void paintCone(QPainter& painter, const Frame& frame, const SonarCone& cone) const;
    void paintRange(QPainter& painter, const Frame& frame, const SonarCone& cone) const;
    void paintRobot(QPainter& painter, const Frame& frame) const;

    /// Sets the tooltip; zero: the range is not known.
    void tellWhat(double farthest_m);

    SonarRing ring_;
};

} // namespace usar::widgets
