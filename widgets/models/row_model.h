// Parts that models of lists and tables share: a base for those whose rows are values of one type, which stores the
// rows and informs the views of changes; and the heads of columns.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <QAbstractItemModel>

namespace usar::widgets {

/// `Base` is QAbstractListModel or QAbstractTableModel. Derived classes say in which order the rows are, and what is
/// shown of them (`data`); views that paint by themselves read `row`. `Row` is a plain value that can be compared. GUI
/// thread.
template <class Row, class Base = QAbstractListModel>
class RowModel : public Base {
public:
    using Base::Base;

    /// `index` 0 is at the top; the reference is valid until the next change.
    const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
    /// Number of rows; 0 for any valid parent, because there is no tree.
    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(rows_.size());
    }

protected:
    /// Returns the first row whose member is equal to `key`; nullopt if there is none.
    template <class Key>
    std::optional<int> find(Key Row::*member, const Key& key) const {
        const auto found = std::ranges::find(rows_, key, member);
        return found == rows_.end() ? std::nullopt : std::optional(static_cast<int>(found - rows_.begin()));
    }
    /// Replaces all rows. Views keep their selection if `key_of` returns the same for the new rows as for the old ones;
    /// otherwise the model is reset. Equal rows change nothing.
    template <class KeyOf>
    void replaceAll(std::vector<Row> rows, KeyOf key_of) {
        const bool same_keys = std::ranges::equal(rows, rows_, {}, key_of, key_of);
        if (!same_keys)
            this->beginResetModel();
        const std::vector<Row> before = std::exchange(rows_, std::move(rows));
        const QAbstractItemModel& all = *this;
        if (!same_keys)
            this->endResetModel();
        else if (rows_ != before)
            emit this->dataChanged(all.index(0, 0), all.index(rowCount() - 1, all.columnCount() - 1));
    }
    /// Inserts a row above the one that is at `at` now, or as the last one.
    void insert(int at, const Row& row) {
        this->beginInsertRows({}, at, at);
        rows_.insert(rows_.begin() + at, row);
        this->endInsertRows();
    }
    /// Replaces the row that is at `at`, whether it differs or not.
    void change(int at, const Row& row) {
        rows_[static_cast<std::size_t>(at)] = row;
        emit this->dataChanged(this->index(at, 0), this->index(at, 0));
    }
    /// Removes the row that is at `at`; those below it move up.
    void remove(int at) {
        this->beginRemoveRows({}, at, at);
        rows_.erase(rows_.begin() + at);
        this->endRemoveRows();
    }

    /// From top to bottom. Whoever changes them directly must inform the views.
    std::vector<Row> rows_;
};

/// Returns the head of a column for QAbstractItemModel::headerData: its title or, for both head and cells, how the text
/// is aligned horizontally. Invalid for other roles, and for rows.
inline QVariant columnHead(Qt::Orientation orientation, int role, const QString& title, Qt::AlignmentFlag alignment) {
    if (orientation != Qt::Horizontal)
        return {};
    return role == Qt::DisplayRole         ? QVariant(title)
           : role == Qt::TextAlignmentRole ? QVariant(static_cast<int>(alignment | Qt::AlignVCenter))
                                           : QVariant();
}

} // namespace usar::widgets
