#include "widgets/models/robot_list_model.h"

#include <algorithm>

#include <QObject>
#include <QStringList>

#include "widgets/models/figures.h"

namespace usar::widgets {
namespace {

bool before(const RobotRow& a, const RobotRow& b) {
    return a.number != b.number ? a.number < b.number : a.id < b.id;
}

} // namespace

QString controlText(const ControlWords& words) {
    switch (words.driver) {
    case Driver::Behavior:
        return words.by.isEmpty() ? QObject::tr("a behavior drives") : QObject::tr("%1 drives").arg(words.by);
    case Driver::Person:
        return words.by.isEmpty() ? QObject::tr("you drive") : QObject::tr("you drive · %1").arg(words.by);
    case Driver::Nobody:
        break;
    }
    return QObject::tr("nobody drives");
}

void RobotListModel::setRobots(std::vector<RobotRow> robots) {
    std::ranges::sort(robots, before);
    if (std::ranges::equal(robots, rows_, {}, &RobotRow::id, &RobotRow::id)) {
        for (const RobotRow& robot : robots)
            updateRobot(robot);
        return;
    }
    beginResetModel();
    rows_ = std::move(robots);
    endResetModel();
}

void RobotListModel::updateRobot(const RobotRow& robot) {
    if (const std::optional<int> known = indexOf(robot.id)) {
        if (row(*known) == robot)
            return;
        if (row(*known).number == robot.number) {
            rows_[static_cast<std::size_t>(*known)] = robot;
            emit dataChanged(index(*known), index(*known));
            return;
        }
        removeRobot(robot.id);
    }
    const auto place = std::ranges::upper_bound(rows_, robot, before);
    const int at = static_cast<int>(place - rows_.begin());
    beginInsertRows({}, at, at);
    rows_.insert(place, robot);
    endInsertRows();
}

void RobotListModel::removeRobot(RobotId id) {
    const std::optional<int> at = indexOf(id);
    if (!at)
        return;
    beginRemoveRows({}, *at, *at);
    rows_.erase(rows_.begin() + *at);
    endRemoveRows();
}

std::optional<int> RobotListModel::indexOf(RobotId id) const {
    const auto found = std::ranges::find(rows_, id, &RobotRow::id);
    return found == rows_.end() ? std::nullopt : std::optional(static_cast<int>(found - rows_.begin()));
}

int RobotListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant RobotListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole))
        return {};
    const RobotRow& robot = row(index.row());
    QStringList parts = {robot.name, robot.class_name, robot.state};
    if (!robot.driver.robot.isEmpty())
        parts << controlText(robot.driver);
    if (robot.battery_pct)
        parts << tr("battery %1 %").arg(figure(*robot.battery_pct, 0));
    if (robot.stale)
        parts << tr("no news");
    parts.removeAll(QString());
    QString text = parts.join(QStringLiteral(", "));
    if (role == Qt::ToolTipRole && robot.number >= 1 && robot.number <= 9)
        text += u'\n' + tr("Key %1 selects").arg(robot.number);
    return text;
}

} // namespace usar::widgets
