// The scanner's rays: a belly scanner's in the robot's cross-section, with the terrain line under them (thesis 4.2), or
// those of one that looks ahead, from above.
#pragma once

#include <QWidget>

#include "widgets/models/laser_section.h"

namespace usar::widgets {

/// Where the beam at angle 0 looks. The scan does not say; robots in the air carry theirs on the belly.
enum class ScanPlane { Below, Ahead };

/// Seen from behind, or from above with what is ahead on top: the robot's left is on the left. The scale is the same in
/// both directions and changes in round steps only. GUI thread.
class LaserFanView : public QWidget {
    Q_OBJECT
public:
    explicit LaserFanView(QWidget* parent = nullptr);

    /// Replaces the picture and makes it fresh again. The scan carries no maximum, so the caller says it (metres).
    void setScan(const protocol::RangeScan& scan, double maximum_m = 20.0, ScanPlane plane = ScanPlane::Below);
    /// Back to the sentence that says what will appear here.
    void clear();
    /// Drawn grey, with the word: nobody vouches for it any more.
    void setStale(bool stale);
    const LaserSection& section() const { return section_; }
    QSize sizeHint() const override { return {280, 160}; }
    QSize minimumSizeHint() const override { return {160, 72}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// `scale` is pixels per metre, `origin` the scanner in pixels.
    void paintRays(QPainter& painter, const QPointF& origin, double scale) const;
    void paintSurface(QPainter& painter, const QPointF& origin, double scale) const;
    void paintRobot(QPainter& painter, const QPointF& origin) const;
    void paintWords(QPainter& painter, double scale) const;
    /// "6.02 m to ground", "3.10 m ahead", and the like where nothing is in range.
    QString clearanceText(int digits) const;
    QPointF onScreen(const LaserRay& ray, const QPointF& origin, double scale) const;

    LaserSection section_;
    ScanPlane plane_ = ScanPlane::Below;
    bool stale_ = false;
};

} // namespace usar::widgets
