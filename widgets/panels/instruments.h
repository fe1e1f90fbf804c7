// Instruments of the selected robot: the rays of a range scanner, of a belly scanner in the robot's cross-section with
// the terrain line below (thesis 4.2), of a scanner that looks ahead from above; the mapped ground along the robot's
// course from the side; and the sonars as columns with their risk zones (thesis 4.2).
#pragma once

#include "core/agent/published.h"
#include "core/mapping/profile.h"
#include "core/protocol/usual_values.h"
#include "widgets/models/ranges.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// Direction of the beam at angle 0. The scan does not tell it; flying robots carry their scanner on the belly.
enum class ScanPlane { Below, Ahead };

/// Seen from behind (Below), or from above with the direction of travel at the top (Ahead); the robot's left is on the
/// left in both cases. Both axes have the same scale, which changes only in round steps. GUI thread.
class LaserFanView : public Instrument {
    Q_OBJECT
public:
    explicit LaserFanView(QWidget* parent = nullptr);

    /// Replaces the picture, which then counts as fresh. `maximum_m` is the scanner's maximum range in meters, which
    /// the scan itself does not carry.
    void setScan(const protocol::RangeScan& scan, double maximum_m = protocol::usual_scanner_maximum_m,
                 ScanPlane plane = ScanPlane::Below);
    /// Shows the sentence that says what will appear here.
    void clear() { setScan({}); }
    QSize sizeHint() const override { return {280, 160}; }
    QSize minimumSizeHint() const override { return {160, 112}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// `scale` is in pixels per meter; `origin` is the scanner's place in pixels.
    void paintRays(QPainter& painter, const QPointF& origin, double scale) const;
    /// Draws the terrain line (Below), or a dot for each hit (Ahead).
    void paintSurface(QPainter& painter, const QPointF& origin, double scale) const;
    void paintRobot(QPainter& painter, const QPointF& origin) const;
    void paintWords(QPainter& painter, double scale) const;
    /// "6.02 m to ground" or "3.10 m ahead", with a dash if nothing is in range. `digits` is the width of the number.
    QString clearanceText(int digits) const;
    QPointF onScreen(const LaserRay& ray, const QPointF& origin, double scale) const;

    LaserSection section_;
    ScanPlane plane_ = ScanPlane::Below;
};

/// Behind the robot is on the left, ahead on the right; in meters. The line is interrupted where the map has no data.
/// Heights are stretched in round steps to fill the sheet, and the lowest and highest are labeled. GUI thread.
class TerrainProfileView : public Instrument {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// Replaces the picture, which then counts as fresh.
    void setProfile(const mapping::CourseProfile& profile);
    /// Shows the sentence that says what will appear here.
    void clear() { setProfile({}); }
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

/// The height of a column is its reading; the zones are bands at its foot with a line at each threshold. Risk is shown
/// by color, word and shape. GUI thread.
class SonarColumnsView : public Instrument {
    Q_OBJECT
public:
    explicit SonarColumnsView(QWidget* parent = nullptr);

    /// Replaces all columns, which then count as fresh; the same again cost nothing. They are in the order of `zones`.
    /// Without limits a sonar has no bands.
    void setZones(const agent::SonarZones& zones);
    void clear() { setZones({}); }
    QSize sizeHint() const override { return {280, 150}; }
    QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Paints the reading on top, the column, its name and the word for its risk, all within `cell`.
    void paintColumn(QPainter& painter, const agent::SonarZone& column, const QRectF& cell) const;
    /// Paints the bands from the foot of the column up to each threshold, in the column's scale.
    void paintZones(QPainter& painter, const agent::SonarZone& column, const QRectF& shaft) const;

    std::vector<agent::SonarZone> columns_;
};

} // namespace usar::widgets
