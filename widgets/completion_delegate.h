// A completion with its help beside it.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// The word in fixed pitch, the help muted behind it. GUI thread.
class CompletionDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    static constexpr int help_role = Qt::UserRole;

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
