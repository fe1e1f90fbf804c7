// The mapped ground along the robot's course, from the side, with the robot above it.
#pragma once

#include <QWidget>

#include "core/mapping/profile.h"

namespace usar::widgets {

/// Behind the robot is on the left, ahead on the right; metres. Where the map knows nothing the line is broken. Heights
/// are stretched to fill the sheet, in round steps, and two of them are written at the side. GUI thread.
class TerrainProfileView : public QWidget {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// Replaces the picture and makes it fresh again.
    void setProfile(const mapping::CourseProfile& profile);
    /// Back to the sentence that says what will appear here.
    void clear();
    /// Drawn grey, with the word: the robot may be elsewhere by now.
    void setStale(bool stale);
    const mapping::CourseProfile& profile() const { return profile_; }
    /// "6.1 m above the map", or what is missing.
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
    /// Room for the two written heights, beside the drawing and never under it.
    static double scaleWidth_px(const Span& span);
    QPointF place(double distance_m, double height_m, const QRectF& plot, const Span& span) const;
    void paintRobot(QPainter& painter, const QRectF& plot, const Span& span) const;
    void paintScale(QPainter& painter, const QRectF& plot, const Span& span) const;

    mapping::CourseProfile profile_;
    bool stale_ = false;
};

} // namespace usar::widgets
