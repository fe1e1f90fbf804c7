// The sensor panel: every value that the robot sends, how old it is, and the way into a plot.
#pragma once

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
/// only keeps the newest line of each stream. Return or a double-click on a number plots it, and so does a drag. GUI
/// thread.
class SensorPanel : public QWidget {
    Q_OBJECT
public:
    explicit SensorPanel(QWidget* parent = nullptr);

    /// `now` is the clock that ages are counted on: the protocol's, as of this line.
    void take(const protocol::InfoLine& line, Seconds now);
    /// The same clock between lines, so that silence ages too.
    void setNow(Seconds now) { now_ = now; }
    /// Without a link everything that repeats is stale at once.
    void setLinked(bool linked) { linked_ = linked; }
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
    void plot(const QModelIndex& index);

    SensorModel* model_;
    QSortFilterProxyModel* filtered_;
    QLineEdit* search_;
    QTreeView* tree_;
    EmptyState* empty_state_;
    NewestLines newest_;
    QTimer frame_;
    Seconds now_{0.0};
    bool linked_ = true;
};

} // namespace usar::widgets
