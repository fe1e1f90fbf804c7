// Paints an entry of a completion list with its help text beside it.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// Paints the word in fixed pitch, and the help text muted after it. GUI thread.
class CompletionDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    /// Item data role of the help text (QString).
    static constexpr int help_role = Qt::UserRole;

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
