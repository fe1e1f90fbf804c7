// Instrument that draws the rays of a range scanner: of a belly scanner in the robot's cross-section, with the terrain
// line below (thesis 4.2); of a scanner that looks ahead from above.
#pragma once

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
    void clear();
    /// The rays as drawn; no rays before the first scan.
    const LaserSection& section() const { return section_; }
    QSize sizeHint() const override { return {280, 160}; }
    QSize minimumSizeHint() const override { return {160, 72}; }

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

} // namespace usar::widgets
