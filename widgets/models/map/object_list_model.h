// Table model of the objects of the world: name, place, speed.
#pragma once

#include <optional>
#include <vector>

#include "widgets/models/map/map_object.h"
#include "widgets/models/row_model.h"

namespace usar::widgets {

/// Icon name for a class of objects; a question mark for unknown classes.
QString kindIcon(const QString& kind);

/// The kind is an icon beside the name, and a word for assistive tools. Sorted by name with numbers in numeric order
/// (Crate2 before Crate10). GUI thread.
class ObjectListModel : public RowModel<MapObject, QAbstractTableModel> {
    Q_OBJECT
public:
    enum Column { Name, Place, Speed, column_count };
    using RowModel::RowModel;

    /// Replaces all objects. Views keep their selection if the names are the same.
    void setObjects(std::vector<MapObject> objects);
    /// Row of that object; nullopt if there is none.
    std::optional<int> indexOf(const QString& name) const { return find(&MapObject::name, name); }

    int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : column_count; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
};

} // namespace usar::widgets
