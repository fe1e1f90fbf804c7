// Paints a row of the notification list: severity icon, the sentence with line breaks, a muted line with severity, time
// and count, and a button if something is offered.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// For a QListView on a NotificationModel; rows are as high as their text needs at the view's width.
class NotificationDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// A click on the button accepts the offer.
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
