// Plots of any numeric fields over protocol time: tool bar, canvases, table with values, cursors and statistics.
#pragma once

#include <QComboBox>
#include <QJsonArray>
#include <QSplitter>
#include <QThreadPool>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/plot/plot_model.h"
#include "widgets/panels/plot_canvas.h"
#include "widgets/panels/plot_legend.h"

namespace usar::widgets {

class ElidedLabel;
class EmptyState;

/// Records the watched fields even while hidden or paused; draws at most 30 times per second and only while visible.
/// Gestures are those of the PlotCanvas. Keys, even if the window has shortcuts on them: Space pauses, F follows, + and
/// - zoom, A and B place cursors, left and right move the active cursor (with Shift in large steps) or else pan, Delete
/// removes the active cursor, or in the table the selected series; Return sends a replay to the active cursor. GUI
/// thread; files are written in a pool thread.
class PlotView : public QWidget {
    Q_OBJECT
public:
    explicit PlotView(QWidget* parent = nullptr);
    /// Waits until files that are being saved are complete.
    ~PlotView() override;

    /// Plots a field of the selected robot on the chosen canvas; `path` as protocol::Field::path() returns it. An empty
    /// or known path changes nothing.
    void addSeries(const QString& path, const QString& unit = {});
    /// Removes all series and their samples.
    void clear();
    /// Adds a canvas below the others and chooses it.
    void addCanvas();
    /// Removes the chosen canvas with its series.
    void removeCanvas();
    /// Discards the samples of this robot, whose replay begins again.
    void restart(const QString& robot);
    /// The selected robot; its values are shown while the plots follow the selection. Empty: none.
    void setRobot(const QString& robot);
    /// The robot is gone.
    void forget(const QString& robot) { model_.forget(robot.toStdString()); }
    /// Call it for every line of every robot; `now` is the protocol time for messages without a time of their own.
    void take(const QString& robot, const protocol::InfoLine& line, Seconds now);
    /// The time at which the selected replay is, on the protocol clock; nullopt: the robot is no replay.
    void setMoment(std::optional<Seconds> time);

    /// Canvases, series and options.
    QJsonObject plotLayout() const { return toJson(model_.layout()); }
    /// Restores what `plotLayout` returned. Samples of fields that stay are kept. An error changes nothing.
    Result<void> setPlotLayout(const QJsonObject& layout);
    /// Restores canvases with their series as `edited` told them; the options stay as they are.
    void setCanvases(const QJsonArray& canvases);

    bool paused() const { return pause_->isChecked(); }
    /// Writes what is plotted to a file of the kind that its suffix names: "pdf" or "png", all canvases with a legend;
    /// "csv", all values in SI units (see csvOf). The file is replaced atomically, in a pool thread; then `saved` or
    /// `failed` is emitted.
    void save(const QString& file);
    PlotCanvas* canvas() const { return canvas_; }
    const PlotModel& model() const { return model_; }
    /// All recorded samples, in SI units and radians.
    const SeriesStore& store() const { return model_.store(); }
    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {240, 110}; }

signals:
    /// The file is complete.
    void saved(const QString& file);
    /// Saving failed; `text` is a sentence for a notification.
    void failed(const QString& text);
    /// A person has added or removed lines or canvases; a layout that is restored is no edit. `text`: what was done,
    /// "plot SEN Sonar/F1/range". The canvases are those of `plotLayout`.
    void edited(const QString& text, const QJsonArray& before, const QJsonArray& after);
    /// The user wants the selected replay to go to this time.
    void momentRequested(usar::Seconds time);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeTools();
    void fillWindowChoice();
    void fillExportMenu();
    void connectParts();
    /// Returns false if the plot does not use the key.
    bool runKey(const QKeyEvent& event);
    /// For keys that only one of cursors and pictures need.
    bool runArrow(int direction, bool far);
    void askForFile(const QString& title, const QString& filter);
    void removeSelected();
    void addAll(const QStringList& paths, const QString& unit);
    QJsonArray canvases() const;
    /// Shows the changed list and emits `edited`, if anything has changed since `before`.
    void endEdit(const QString& text, const QJsonArray& before);
    /// Shows another layout or other series.
    void listChanged();
    void showTools();
    /// Gives the table the width that its columns need, as far as the plots keep theirs.
    void giveTableRoom();
    void showValues();
    /// Shows the time at the mouse, or how to move in the plot.
    void showReadout();
    /// Starts the frame timer if the view is visible.
    void refreshSoon();
    void refresh();

    PlotModel model_;
    PlotCanvas* canvas_;
    PlotLegend* legend_;
    QSplitter* halves_;
    ElidedLabel* readout_ = nullptr;
    EmptyState* empty_state_ = nullptr;
    QToolButton* pause_ = nullptr;
    QToolButton* follow_ = nullptr;
    QToolButton* follow_robot_ = nullptr;
    QToolButton* statistics_ = nullptr;
    QToolButton* remove_canvas_ = nullptr;
    QToolButton* export_ = nullptr;
    QComboBox* window_ = nullptr;
    QTimer frame_;
    QThreadPool disk_;
};

} // namespace usar::widgets
