// The belly scanner's rays in the robot's cross-section, with the terrain line under them (thesis 4.2).
#pragma once

#include <QWidget>

#include "widgets/models/laser_section.h"

namespace usar::widgets {

/// Seen from behind: the robot's left is on the left. The scale is the same in both directions and changes in round
/// steps only. GUI thread.
class LaserFanView : public QWidget {
    Q_OBJECT
public:
    explicit LaserFanView(QWidget* parent = nullptr);

    /// Replaces the picture and makes it fresh again. The scan carries no maximum, so the caller says it (metres).
    void setScan(const protocol::RangeScan& scan, double maximum_m = 20.0);
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
    void paintWords(QPainter& painter, double scale) const;

    LaserSection section_;
    bool stale_ = false;
};

} // namespace usar::widgets
