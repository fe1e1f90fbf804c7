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
    return QObject::tr("idle");
}

void RobotListModel::updateRobot(const RobotRow& robot) {
    if (const std::optional<int> known = indexOf(robot.id)) {
        if (row(*known) == robot)
            return;
        if (row(*known).number == robot.number)
            return change(*known, robot);
        remove(*known);
    }
    insert(static_cast<int>(std::ranges::upper_bound(rows_, robot, before) - rows_.begin()), robot);
}

void RobotListModel::removeRobot(RobotId id) {
    if (const std::optional<int> at = indexOf(id))
        remove(*at);
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
