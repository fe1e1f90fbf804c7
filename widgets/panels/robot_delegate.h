// Paints a robot's row: color chip with its number, name, class, state in words, battery bar.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

struct RobotRow;

/// For a view on a RobotListModel. Stale rows are gray with the state struck through and the words "no news".
class RobotDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
