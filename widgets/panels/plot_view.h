// Plots of any numeric fields over protocol time: tool bar, drawing surface, legend with the newest values.
#pragma once

#include <QComboBox>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QWidget>

#include "core/base/result.h"
#include "widgets/models/series_store.h"
#include "widgets/panels/plot_canvas.h"

namespace usar::widgets {

class ElidedLabel;
class EmptyState;

/// Records the watched fields even while hidden or paused; draws at most 30 times per second and only while visible.
/// The wheel zooms time at the cursor, or a value axis if it is over one; drag pans; double-click follows the newest
/// values again. Keys, even if the window has shortcuts on them: Space pauses, F follows, + and - zoom, left and right
/// pan, Delete in the legend removes series. GUI thread.
class PlotView : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);

    /// Starts to watch a field; `path` as protocol::Field::path() returns it. An empty or known path changes nothing.
    void addSeries(const QString& path, const QString& unit = {});
    /// Removes all series and their samples.
    void clear();
    /// Keeps the watched fields and discards the samples, for another robot.
    void restart();
    /// Name of the robot that the values belong to, shown as the legend's heading; empty: no heading.
    void setSource(const QString& robot_name);
    /// Call it for every line of the connection; `now` is the protocol time for messages without a time of their own.
    void take(const protocol::InfoLine& line, Seconds now);

    bool paused() const { return pause_->isChecked(); }
    /// Writes all recorded values in SI units, see csvOf(). The file is replaced atomically.
    Result<void> exportCsv(const QString& file) const;
    /// Writes the visible picture with a legend, as PNG at twice the size.
    Result<void> exportPicture(const QString& file) const;
    PlotCanvas* canvas() const { return canvas_; }
    /// All recorded samples, in SI units and radians.
    const SeriesStore& store() const { return store_; }
    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {240, 110}; }

signals:
    /// An export failed; `text` is a sentence for a notification.
    void failed(const QString& text);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeTools();
    QWidget* makeLegend();
    void fillWindowChoice();
    /// Returns false if the plot does not use the key.
    bool runKey(const QKeyEvent& event);
    /// Calls `write` with the file that the user chooses.
    void askForFile(const QString& title, const QString& filter, Result<void> (PlotView::*write)(const QString&) const);
    void removeSelected();
    void listChanged();
    void rebuildLegend();
    /// Shows the values at the cursor, or the newest ones while there is no cursor.
    void updateLegendValues();
    /// Shows the time at the cursor, or how to move in the plot.
    void showReadout();
    /// Starts the frame timer if the view is visible.
    void refreshSoon();
    void refresh();

    SeriesStore store_;
    PlotCanvas* canvas_ = new PlotCanvas(this);
    QTreeWidget* legend_ = new QTreeWidget(this);
    ElidedLabel* readout_ = nullptr;
    EmptyState* empty_state_;
    QToolButton* pause_ = nullptr;
    QToolButton* follow_ = nullptr;
    QToolButton* export_ = nullptr;
    QComboBox* window_ = nullptr;
    QTimer frame_;
};

} // namespace usar::widgets
