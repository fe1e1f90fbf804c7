// How the robot leans, as an artificial horizon, and where it heads, as an arrow in the map's own directions.
#pragma once

#include "core/base/geometry.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// The horizon is seen from the robot: the ground rises on the side that is lower. The arrow points as the robot's
/// arrow on the map does, with x to the right and y up, because no server tells where north is. GUI thread.
class AttitudeView : public Instrument {
    Q_OBJECT
public:
    explicit AttitudeView(QWidget* parent = nullptr);

    /// Roll, pitch and yaw of the base in the map frame, in rad; `source` is the sensor that tells them. New ones
    /// count as fresh; the same again cost nothing.
    void setAttitude(const Vec3& roll_pitch_yaw_rad, const QString& source);
    QSize sizeHint() const override { return {280, minimumSizeHint().height() + 24}; }
    QSize minimumSizeHint() const override;

    /// "3° right", "level": words for a roll in rad; positive lowers the right side.
    static QString rollText(double roll_rad);
    /// "5° up": words for a pitch in rad; positive lowers the nose.
    static QString pitchText(double pitch_rad);
    /// "yaw 87°", from -179 to 180.
    static QString yawText(double yaw_rad);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintHorizon(QPainter& painter, const QPointF& center, double radius) const;
    /// Paints the lines of the pitch scale, every ten degrees; the painter is turned by the roll.
    void paintLadder(QPainter& painter, double radius, double pixels_per_rad) const;
    /// Paints the marks of the roll scale, and the pointer to the roll.
    void paintRollScale(QPainter& painter, const QPointF& center, double radius) const;
    /// Paints what stands for the robot, which does not move.
    void paintWings(QPainter& painter, const QPointF& center, double radius) const;
    void paintCompass(QPainter& painter, const QPointF& center, double radius) const;

    Vec3 roll_pitch_yaw_rad_ = Vec3::Zero();
    QString source_; ///< empty: nothing was heard yet
};

} // namespace usar::widgets
