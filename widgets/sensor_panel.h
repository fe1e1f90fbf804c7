// The sensor panel: every value that the robot sends, how old it is, and the way into a plot.
#pragma once

#include <functional>

#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTimer>
#include <QTreeView>
#include <QWidget>

#include "widgets/models/newest_lines.h"
#include "widgets/models/sensor_model.h"

namespace usar::widgets {

class EmptyState;

/// Lines in, plot wishes out. Repaints ten times a second, which is as fast as figures can be read; while hidden it
/// only keeps the newest line of each stream. Ages count on the protocol's clock; where that stands still for longer
/// than 2 s of wall time though nobody paused the simulation, all values are stale and ages go on by wall time. Return
/// or a double-click on a number plots it, and so does a drag. GUI thread.
class SensorPanel : public QWidget {
    Q_OBJECT
public:
    explicit SensorPanel(QWidget* parent = nullptr);

    /// `now` is the clock that ages are counted on: the protocol's, as of this line.
    void take(const protocol::InfoLine& line, Seconds now);
    /// The same clock between lines, so that silence ages too.
    void setNow(Seconds now);
    /// Without a link everything that repeats is stale at once.
    void setLinked(bool linked);
    /// While the simulation is paused its clock may stand still without anything being wrong.
    void setPaused(bool paused);
    /// Stands in for the wall clock in tests.
    void setWallClock(std::function<Seconds()> wall_clock);
    /// Another robot, another set of sensors.
    void clear();
    /// Shows what came since the last time; the panel's own timer calls it while visible.
    void refresh();
    const SensorModel& model() const { return *model_; }
    QSize sizeHint() const override { return {300, 240}; }

signals:
    /// `path` as protocol::Field::path() gives it.
    void plotRequested(const QString& path, const QString& unit);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void makeTree();
    /// The protocol's clock moved or a line came.
    void heard(Seconds now);
    /// By wall time since the clock last moved.
    Seconds silence() const { return wall_clock_() - heard_at_; }
    bool silent() const;
    void plot(const QModelIndex& index);

    SensorModel* model_;
    QSortFilterProxyModel* filtered_;
    QLineEdit* search_;
    QTreeView* tree_;
    EmptyState* empty_state_;
    NewestLines newest_;
    QTimer frame_;
    std::function<Seconds()> wall_clock_;
    Seconds now_{0.0};
    Seconds heard_at_{0.0}; ///< wall time
    Seconds pace_{0.0};     ///< wall time between the last two steps of the clock: long in slow simulations
    bool linked_ = true;
    bool paused_ = false;
};

} // namespace usar::widgets
