// Drawing surface of a plot: axes over protocol time, one line per series. The only class that uses QCustomPlot.
#pragma once

#include <map>
#include <set>
#include <string>

#include <QPixmap>
#include <QWidget>

#include "widgets/models/series_store.h"

class QCPAxis;
class QCPGraph;
class QCPItemStraightLine;
class QCustomPlot;

namespace usar::widgets {

/// Draws on request (`show`), and by itself after a gesture: the wheel zooms time (over a value axis: that axis), drag
/// pans, double-click resumes following. A vertical line follows the mouse. Angles are drawn in degrees. The first unit
/// uses the left axis, the second the right one, all others share the left. Colors follow the theme. GUI thread.
class PlotCanvas : public QWidget {
    Q_OBJECT
public:
    explicit PlotCanvas(QWidget* parent = nullptr);

    /// Updates lines and axes from the store; copies only new samples.
    void show(const SeriesStore& store);
    /// Removes only the lines that are no longer watched; the rest of the picture stays as it is.
    void dropLines(const SeriesStore& store);
    /// Sets the time span that is visible while following, and starts to follow; infinite: everything.
    void setWindow(Seconds window);
    /// While following, the newest sample is at the right edge and the value axes fit. Emits nothing.
    void setFollowing(bool following);
    bool following() const { return following_; }
    /// Draws the lines of these paths thicker.
    void emphasize(const std::set<std::string>& paths);
    /// Zooms around the middle of the visible span; a factor above 1 shows less time in more detail. Ends following.
    void zoomTime(double factor);
    /// Moves by a fraction of the visible span; positive is later. Ends following.
    void panTime(double fraction);

    /// Edges of the visible span on the protocol clock; samples need not reach that far.
    Seconds visibleFrom() const;
    Seconds visibleTo() const;
    /// Time under the mouse on the protocol clock; nullopt while the mouse is elsewhere.
    std::optional<Seconds> cursor() const;
    /// Number of samples in the line as drawn; 0 for a path that is not watched.
    int sampleCount(const std::string& path) const;
    /// The plot as on the screen, with a legend and at twice the resolution, for files.
    QPixmap picture() const;
    /// Color of the `index`-th line; readable in the current theme.
    static QColor lineColor(int index);

signals:
    /// By a gesture or by zoomTime() and panTime().
    void followingChanged(bool following);
    /// The mouse moved over the plot, or left it.
    void cursorMoved();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Line {
        QCPGraph* graph = nullptr;
        std::uint64_t history = 0; ///< history of the series that was copied
        std::uint64_t taken = 0;   ///< number of samples copied or skipped so far
    };

    void connectGestures();
    void makeCursor();
    /// Moves the line to this place, or hides it outside of the axes.
    void moveCursor(const QPointF& at_px);
    /// Stops following and emits followingChanged if that is a change.
    void leaveFollowing();
    /// Directs the wheel to the axis under the mouse.
    void aimWheel(const QPointF& at_px);
    /// Adds and removes lines so that they match the store.
    void matchLines(const SeriesStore& store);
    /// Copies the new samples of a series into its line.
    void feed(const Series& series);
    /// Assigns each line to the axis of its unit.
    void assignAxes(const SeriesStore& store);
    /// Shows the window that ends at the newest sample.
    void fitTime();
    /// Fits the value axes to the visible samples, unless the user has zoomed one.
    void fitValues();
    void fitAxis(QCPAxis* axis);
    void applyTheme();
    void styleLines();
    void styleAxis(QCPAxis* axis);
    void chooseTimeFormat();

    QCustomPlot* plot_;
    QCPItemStraightLine* cursor_line_ = nullptr;
    std::optional<double> cursor_px_; ///< stays under the mouse while the picture moves
    std::map<std::string, Line> lines_;
    std::vector<std::string> order_; ///< order of the store: determines color and legend
    std::set<std::string> emphasized_;
    Seconds window_{60.0};
    std::optional<double> oldest_s_;
    std::optional<double> newest_s_;
    bool following_ = true;
    bool values_fitted_ = true; ///< until the user zooms a value axis
};

} // namespace usar::widgets
