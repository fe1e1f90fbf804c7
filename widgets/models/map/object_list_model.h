// Table model of the objects of the world: name, place, speed.
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "widgets/models/map/map_object.h"

namespace usar::widgets {

/// Icon name for a class of objects; a question mark for unknown classes.
QString kindIcon(const QString& kind);

/// The kind is an icon beside the name, and a word for assistive tools. Sorted by name with numbers in numeric order
/// (Crate2 before Crate10). GUI thread.
class ObjectListModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Place, Speed, column_count };
    using QAbstractTableModel::QAbstractTableModel;

    /// Replaces all objects. Views keep their selection if the names are the same.
    void setObjects(std::vector<MapObject> objects);
    /// The reference is valid until the next setObjects.
    const MapObject& object(int row) const { return objects_[static_cast<std::size_t>(row)]; }
    /// Row of that object; -1 if there is none.
    int rowOf(const QString& name) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : column_count; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<MapObject> objects_;
};

} // namespace usar::widgets
