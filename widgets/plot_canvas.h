// The drawing surface of a plot: axes over protocol time, one line a series. The only class that knows QCustomPlot.
#pragma once

#include <map>
#include <set>
#include <string>

#include <QPixmap>
#include <QWidget>

#include "widgets/models/series_store.h"

class QCPAxis;
class QCPGraph;
class QCustomPlot;

namespace usar::widgets {

/// Draws when told (`show`), and by itself after a gesture: wheel zooms time (over a value axis: that axis), drag pans,
/// double-click goes back to following. Angles are drawn in degrees. The first unit has the left axis, the second
/// the right one, others share the left. Colors follow the theme. GUI thread.
class PlotCanvas : public QWidget {
    Q_OBJECT
public:
    explicit PlotCanvas(QWidget* parent = nullptr);

    /// Brings lines and axes up to date with the store; only new samples are copied.
    void show(const SeriesStore& store);
    /// Only takes lines off that are no longer watched; what is drawn stands still.
    void dropLines(const SeriesStore& store);
    /// How much time is seen while following; infinite for all there is.
    void setWindow(Seconds window);
    /// Keeps the newest sample at the right edge and the values fitted.
    void setFollowing(bool following);
    bool following() const { return following_; }
    /// Draws these thicker.
    void emphasize(const std::set<std::string>& paths);
    /// About the middle of what is seen; above 1 shows less time in more detail. Ends following.
    void zoomTime(double factor);
    /// By a fraction of what is seen; positive is later.
    void panTime(double fraction);

    /// The edges of what is seen, on the protocol's clock; there may be no sample there.
    Seconds visibleFrom() const;
    Seconds visibleTo() const;
    /// Of the line as it is drawn; 0 for a path that is not watched.
    int sampleCount(const std::string& path) const;
    /// As on the screen, with a legend, for files.
    QPixmap picture() const;
    /// Of the `index`-th line; readable on the current theme's surface.
    static QColor lineColor(int index);

signals:
    /// By a gesture.
    void followingChanged(bool following);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Line {
        QCPGraph* graph = nullptr;
        std::uint64_t history = 0; ///< of the series that was copied
        std::uint64_t taken = 0;   ///< samples copied or skipped so far
    };

    void connectGestures();
    void leaveFollowing();
    void aimWheel(const QPointF& at_px);
    void matchLines(const SeriesStore& store);
    void feed(const Series& series);
    void assignAxes(const SeriesStore& store);
    void fitTime();
    void fitValues();
    void fitAxis(QCPAxis* axis);
    void applyTheme();
    void styleLines();
    void styleAxis(QCPAxis* axis);
    void chooseTimeFormat();

    QCustomPlot* plot_;
    std::map<std::string, Line> lines_;
    std::vector<std::string> order_; ///< of the store: color and legend
    std::set<std::string> emphasized_;
    Seconds window_{60.0};
    std::optional<double> oldest_s_;
    std::optional<double> newest_s_;
    bool following_ = true;
    bool values_fitted_ = true; ///< until the person zooms a value axis
};

} // namespace usar::widgets
