// Paints a notification's row: severity icon, the sentence wrapped, and a muted line with word, time, count, cure.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// For a QListView on a NotificationModel; rows are as high as their text needs at the view's width.
class NotificationDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
