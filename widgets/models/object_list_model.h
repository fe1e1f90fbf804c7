// The objects of the world as a table: what, where, how fast.
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "widgets/models/map_object.h"

namespace usar::widgets {

/// The icon of a class; a question mark for those that are not ours.
QString kindIcon(const QString& kind);

/// The kind is an icon beside the name, and a word for assistive tools. By name, numbers in names in order (Crate2
/// before Crate10). GUI thread.
class ObjectListModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Place, Speed, column_count };
    using QAbstractTableModel::QAbstractTableModel;

    /// All there are. Views keep their selection where the names are the same.
    void setObjects(std::vector<MapObject> objects);
    const MapObject& object(int row) const { return objects_[static_cast<std::size_t>(row)]; }
    /// -1 where it is not there.
    int rowOf(const QString& name) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<MapObject> objects_;
};

} // namespace usar::widgets
