// Paints a radio link's row: names, quality in a word, bars, dBm, and the history with the threshold.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// For a view on a RadioLinkModel. Quality is shown by word, bars and color; links of unknown strength are gray.
class RadioDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
