// The sensor panel: every value that the robot sends, its age, and a way to plot it.
#pragma once

#include <functional>
#include <utility>

#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTimer>
#include <QTreeView>
#include <QWidget>

#include "widgets/models/sensor_model.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// Takes lines and reports plot requests. Shows what is new ten times a second, which is as fast as numbers can be
/// read; while hidden it only keeps the newest line of each stream. Ages are measured on the protocol clock. If that
/// clock stands still for more than 2 s of wall time (up to 10 s in slow simulations) although nobody paused the
/// simulation, all repeated values are stale and their ages continue by wall time. Return, a double-click or a drag
/// plots a number. GUI thread.
class SensorPanel : public QWidget {
    Q_OBJECT
public:
    explicit SensorPanel(QWidget* parent = nullptr);

    /// `now` is the protocol clock at this line; ages are measured on it.
    void take(const protocol::InfoLine& line, Seconds now);
    /// Sets the protocol clock between lines, so that values also age while nothing arrives.
    void setNow(Seconds now);
    /// Without a link every repeated value is stale at once.
    void setLinked(bool linked) { linked_ = linked; }
    /// While the simulation is paused, a clock that stands still does not make values stale.
    void setPaused(bool paused);
    /// Replaces the wall clock in tests.
    void setWallClock(std::function<Seconds()> wall_clock);
    /// Removes all values, for another robot.
    void clear();
    /// Shows what arrived since the last call; the panel's own timer calls it while visible.
    void refresh();
    const SensorModel& model() const { return *model_; }
    QSize sizeHint() const override { return {300, 240}; }

signals:
    /// The user wants to plot this field; `path` as protocol::Field::path() returns it, `unit` its SI unit.
    void plotRequested(const QString& path, const QString& unit);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeTree();
    /// Shows the sheet that says what will appear, in place of an empty list with its filter and heads.
    void showEmpty(bool empty);
    /// Notes that the protocol clock advanced or a line arrived.
    void heard(Seconds now);
    /// Wall time since the clock last advanced or a line arrived.
    Seconds silence() const { return wall_clock_() - heard_at_; }
    /// True if there is no link or the silence is longer than expected.
    bool silent() const;
    void plot(const QModelIndex& index);

    SensorModel* model_ = new SensorModel(this);
    QSortFilterProxyModel* filtered_ = new QSortFilterProxyModel(this);
    QLineEdit* search_;
    QTreeView* tree_ = new QTreeView(this);
    EmptyState* empty_state_ = new EmptyState(tree_->viewport());
    NewestLines newest_;
    QTimer frame_;
    std::function<Seconds()> wall_clock_;
    Seconds now_{0.0};
    std::pair<Seconds, bool> shown_{-1.0, false}; ///< time and silence that the rows show
    Seconds heard_at_{0.0};                       ///< wall time
    Seconds pace_{0.0}; ///< wall time between the last two steps of the clock; long in slow simulations
    bool linked_ = true;
    bool paused_ = false;
};

} // namespace usar::widgets
