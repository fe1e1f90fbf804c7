// Table beside the plots: their series with the values at the mouse and at the cursors, and statistics.
#pragma once

#include <vector>

#include <QTreeWidget>

#include "widgets/models/plot/plot_model.h"

namespace usar::widgets {

/// One row for each series, in groups if there are several canvases. Columns come and go with the cursors and with the
/// statistics; the head says at which times the cursors are. Owned by the PlotView, GUI thread.
class PlotLegend : public QTreeWidget {
    Q_OBJECT
public:
    explicit PlotLegend(QWidget* parent = nullptr);

    /// What the values belong to, in seconds on the protocol clock.
    struct Times {
        std::optional<double> mouse_s{}; ///< nullopt: the newest value
        double from_s = 0.0;             ///< the visible span
        double to_s = 0.0;
    };

    /// Shows these series; the selection is lost.
    void rebuild(const PlotModel& model);
    /// Shows the figures of the series that are in the table.
    void showValues(const PlotModel& model, const Times& times);
    /// The series of the selected rows.
    const std::vector<ShownSeries>& rows() const { return rows_; }
    std::vector<ShownSeries> selectedRows() const;
    /// The row of the table for a series: an index of rows().
    QTreeWidgetItem* item(std::size_t row) const { return items_[row]; }
    /// The width that the columns need now.
    int wantedWidth() const;

    enum Column { Name, Now, AtA, AtB, Difference, Slope, Count, Least, Most, Mean, Deviation, column_count };

signals:
    /// The user wants the selected series removed.
    void removeRequested();
    /// Columns have appeared or disappeared.
    void columnsChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Gives the names the room that the figures leave.
    void fitName();
    void showColumns(const PlotModel& model);
    void showHead(const PlotModel& model, const Times& times);

    std::vector<ShownSeries> rows_; ///< their `series` must not be used: the model may have changed
    std::vector<QTreeWidgetItem*> items_;
};

} // namespace usar::widgets
