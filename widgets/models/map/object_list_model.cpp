#include "widgets/models/map/object_list_model.h"

#include <algorithm>

#include <QCollator>

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"

namespace usar::widgets {

namespace {

QString cell(const MapObject& object, int column) {
    switch (column) {
    case ObjectListModel::Name:
        return object.name;
    case ObjectListModel::Place:
        return QStringLiteral("%1  %2").arg(figure(object.body_in_map.position_m.x(), 1),
                                            figure(object.body_in_map.position_m.y(), 1));
    default:
        return object.speed_m_s ? figure(*object.speed_m_s, 1) : QString();
    }
}

} // namespace

QString kindIcon(const QString& kind) {
    const QString name = kind == QStringLiteral("SoccerBall") ? QStringLiteral("soccer-ball") : kind.toLower();
    return iconNames().contains(name) ? name : QStringLiteral("help");
}

void ObjectListModel::setObjects(std::vector<MapObject> objects) {
    QCollator collator(QLocale::English); // The collation of the "C" locale has no numeric mode.
    collator.setNumericMode(true);
    std::ranges::sort(objects, [&](const MapObject& a, const MapObject& b) { return collator(a.name, b.name); });
    replaceAll(std::move(objects), &MapObject::name);
}

QVariant ObjectListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const MapObject& one = row(index.row());
    if (role == Qt::DisplayRole)
        return cell(one, index.column());
    if (role == Qt::TextAlignmentRole)
        return headerData(index.column(), Qt::Horizontal, role);
    const QString kind = one.kind.isEmpty() ? tr("unknown kind") : one.kind;
    if (role == Qt::DecorationRole && index.column() == Name)
        return icon(kindIcon(one.kind));
    if (role == Qt::AccessibleTextRole && index.column() == Name)
        return tr("%1, %2").arg(one.name, kind);
    if (role == Qt::ToolTipRole)
        return tr("%1 (%2): %3 × %4 × %5 m, z %6 m, yaw %7°")
            .arg(one.name, kind, figure(one.size_m.x(), 2), figure(one.size_m.y(), 2), figure(one.size_m.z(), 2),
                 figure(one.body_in_map.position_m.z(), 2), figure(degrees(one.body_in_map.yaw_rad), 0));
    return {};
}

QVariant ObjectListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const QString names[] = {tr("Object"), tr("x, y m"), tr("m/s")};
    return columnHead(orientation, role, names[section], section >= Place ? Qt::AlignRight : Qt::AlignLeft);
}

} // namespace usar::widgets
