// Who is there: one row a robot, in the order of their numbers.
#pragma once

#include <optional>
#include <vector>

#include <QAbstractListModel>
#include <QString>

#include "widgets/control_badge.h"

namespace usar::widgets {

/// A robot as the list needs it. `id` is the window's own; `number` 1..9 chooses color and key.
struct RobotRow {
    int id = 0;
    int number = 1;
    QString name;
    QString class_name; ///< "AirRobot"
    QString state;      ///< in words: "scanning lane 4 of 9"
    std::optional<double> battery_pct;
    bool stale = false;    ///< nobody vouches for state and battery any more
    ControlWords driver{}; ///< who drives it
    bool operator==(const RobotRow&) const = default;
};

/// DisplayRole is a whole sentence for assistive tools and type-ahead; views paint from `row`. GUI thread.
class RobotListModel : public QAbstractListModel {
    Q_OBJECT
public:
    using QAbstractListModel::QAbstractListModel;

    /// All there are. Views keep their selection where the ids are the same; other ids reset them.
    void setRobots(std::vector<RobotRow> robots);
    /// Adds a robot with an id that is not there yet. Tells nobody when nothing changed.
    void updateRobot(const RobotRow& robot);
    /// An unknown id is no news.
    void removeRobot(int id);

    /// By row, 0 at the top; the reference holds until the next change.
    const RobotRow& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
    /// The row of that robot; nothing where it is not listed.
    std::optional<int> indexOf(int id) const;
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<RobotRow> rows_; ///< by number, then id
};

} // namespace usar::widgets
