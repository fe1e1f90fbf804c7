// Paints a notification's row: severity icon, the sentence wrapped, a muted line with word, time, count, cure, and a
// button where something is offered.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// For a QListView on a NotificationModel; rows are as high as their text needs at the view's width.
class NotificationDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// A click on the button takes the offer.
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
