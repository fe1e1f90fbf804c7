// Instrument that shows the mapped ground along the robot's course from the side, with the robot above it.
#pragma once

#include "core/mapping/profile.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// Behind the robot is on the left, ahead on the right; in meters. The line is interrupted where the map has no data.
/// Heights are stretched in round steps to fill the sheet, and the lowest and highest are labeled. GUI thread.
class TerrainProfileView : public Instrument {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// Replaces the picture, which then counts as fresh.
    void setProfile(const mapping::CourseProfile& profile);
    /// Shows the sentence that says what will appear here.
    void clear();
    const mapping::CourseProfile& profile() const { return profile_; }
    /// "6.1 m above the map", or "unmapped here".
    QString clearanceText() const;
    QSize sizeHint() const override { return {280, 110}; }
    QSize minimumSizeHint() const override { return {160, 56}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Round heights below and above everything that is drawn.
    struct Span {
        double low_m = 0.0;
        double high_m = 1.0;
    };
    Span span() const;
    /// Width of the column with the two height labels, beside the drawing and never under it.
    static double scaleWidth_px(const Span& span);
    /// Screen position of a point at this distance along the course.
    QPointF place(double distance_m, double height_m, const QRectF& plot, const Span& span) const;
    /// Paints the robot, with a dotted line to the ground below it.
    void paintRobot(QPainter& painter, const QRectF& plot, const Span& span) const;
    /// Paints the height labels and the reach of the profile.
    void paintScale(QPainter& painter, const QRectF& plot, const Span& span) const;

    mapping::CourseProfile profile_;
};

} // namespace usar::widgets
