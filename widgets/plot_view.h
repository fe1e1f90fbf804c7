// Plots of any numeric field over protocol time: tool bar, drawing surface, legend with the newest values.
#pragma once

#include <QComboBox>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QWidget>

#include "core/base/result.h"
#include "widgets/models/field_mime.h"
#include "widgets/models/series_store.h"

namespace usar::widgets {

class EmptyState;
class PlotCanvas;

/// Records whatever is watched, also while hidden or paused; draws at most 30 times a second and only while visible.
/// Wheel zooms time at the cursor, over a value axis that axis; drag pans; double-click follows the newest again.
/// Keys, also where the window has shortcuts on them: Space pauses, F follows, + - zoom, left and right pan, Delete in
/// the legend takes series off. GUI thread.
class PlotView : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);

    /// `path` as protocol::Field::path() gives it. Known paths are left as they are.
    void addSeries(const QString& path, const QString& unit = {});
    /// Forgets its samples too; an unknown path is no news.
    void removeSeries(const QString& path);
    /// In the order in which they were added, which gives the colors.
    QStringList seriesPaths() const;
    /// Takes all series off and forgets their samples.
    void clear();
    /// Keeps what is watched and forgets the samples: another robot, another history.
    void restart();
    /// Whose values these are; the legend's heading. Empty for none.
    void setSource(const QString& robot_name);
    /// Every line of the connection; `now` is the protocol's time for messages that carry none.
    void take(const protocol::InfoLine& line, Seconds now);

    bool paused() const { return pause_->isChecked(); }
    /// SI values of all that is recorded, see csvOf(). Whole or not at all.
    Result<void> exportCsv(const QString& file) const;
    /// What is seen now with a legend, PNG at twice the size.
    Result<void> exportPicture(const QString& file) const;
    PlotCanvas* canvas() const { return canvas_; }
    /// All that is recorded, in SI units and radians.
    const SeriesStore& store() const { return store_; }
    /// Covers the drawing surface while nothing is watched.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {280, 140}; }

public slots:
    /// The picture stands still; recording goes on.
    void setPaused(bool paused);
    /// Keeps the newest sample at the right edge.
    void setFollowing(bool following);

signals:
    /// Something was added, removed or cleared: what a layout remembers.
    void seriesChanged(const QStringList& paths);
    /// An export did not work; a sentence for a notification.
    void failed(const QString& text);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeTools();
    QWidget* makeLegend();
    void fillWindowChoice();
    /// False where the key means nothing here.
    bool runKey(const QKeyEvent& event);
    /// Not modal: a robot may be moving.
    void askForFile(const QString& title, const QString& filter, Result<void> (PlotView::*write)(const QString&) const);
    void legendMenu(const QPoint& at);
    void removeSelected();
    void listChanged();
    void rebuildLegend();
    void updateLegendValues();
    /// Starts the frame timer, if there is somebody to see it.
    void refreshSoon();
    void refresh();

    SeriesStore store_;
    PlotCanvas* canvas_;
    QTreeWidget* legend_;
    EmptyState* empty_state_;
    QToolButton* pause_ = nullptr;
    QToolButton* follow_ = nullptr;
    QToolButton* export_ = nullptr;
    QComboBox* window_ = nullptr;
    QTimer frame_;
};

} // namespace usar::widgets
