// One canvas of the plots: a rectangle with its axes, and the lines of its series.
#pragma once

#include <set>
#include <vector>

#include "widgets/models/plot/plot_model.h"
#include "widgets/style/theme.h"

class QCPAxis;
class QCPAxisRect;
class QCPGraph;
class QCPLegend;
class QCPMarginGroup;
class QCPRange;
class QCustomPlot;

namespace usar::widgets {

/// Color of the `index`-th line of the plots; readable in this theme.
QColor plotLineColor(int index, Theme theme);

/// Gives an axis of a plot the colors and fonts of the theme.
void stylePlotAxis(QCPAxis* axis, const Tokens& tokens);

/// The first unit has the left axis, each other unit an axis on the right. Angles are drawn in degrees. Lines hold no
/// more points than fit on the screen (SampleHistory::curve). Owned by the PlotCanvas, which also owns the plot that
/// all panes are part of. GUI thread.
class PlotPane {
public:
    /// Adds itself to the plot as this row. The sides of all panes with the same `sides` are in line.
    PlotPane(QCustomPlot& plot, QCPMarginGroup& sides, int row);
    /// Takes itself out of the plot.
    ~PlotPane();
    PlotPane(const PlotPane&) = delete;
    PlotPane& operator=(const PlotPane&) = delete;

    QCPAxisRect* rect() const { return rect_; }
    QCPAxis* timeAxis() const;
    /// The axis of the first unit.
    QCPAxis* valueAxis() const;
    /// Shows these series and no others; their lines are empty until `fill`.
    void setSeries(std::vector<ShownSeries> series);
    const std::vector<ShownSeries>& series() const { return series_; }
    /// Draws the lines of the visible time, with nothing after `until_s`; `columns`: width in pixels of the screen.
    void fill(double until_s, int columns);
    /// Fits the value axes to the visible points, unless the user has zoomed one.
    void fitValues();
    /// Fits the value axes again from now on.
    void letValuesFit() { values_fitted_ = true; }
    /// Directs the wheel to the axis at this place of the plot; returns false if that is the time axis.
    bool aimWheel(const QPointF& at_px);
    /// Only the lowest pane has room for the times.
    void setTimesShown(bool shown);
    /// Marks the pane that takes what is plotted next.
    void setChosen(bool chosen) { chosen_ = chosen; }
    /// Colors for a theme; the lines of the `emphasized` keys are thicker.
    void style(Theme theme, const std::set<SeriesKey>& emphasized);
    /// Adds a legend right of the pane; the caller removes it from the plot.
    QCPLegend* addLegend(int row, Theme theme);
    /// Number of points in the line as drawn; 0 for a series that is not shown here.
    int pointCount(const SeriesKey& key) const;

private:
    /// Gives each unit an axis, and each line the axis of its unit.
    void assignAxes();
    void fitAxis(QCPAxis* axis);

    QCustomPlot& plot_;
    QCPAxisRect* rect_; ///< owned by the plot's layout
    std::vector<ShownSeries> series_;
    std::vector<QCPGraph*> graphs_; ///< in the order of series_
    std::vector<QCPAxis*> values_;  ///< value axes, in the order of their units
    bool values_fitted_ = true;     ///< until the user zooms a value axis
    bool chosen_ = false;
};

} // namespace usar::widgets
