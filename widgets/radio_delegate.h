// Paints a radio link's row: names, the word for its quality, bars, dBm, and the last minutes over the cut-off.
#pragma once

#include <QStyledItemDelegate>

namespace usar::widgets {

/// For a view on a RadioLinkModel. Quality is word, bars and color; what nobody vouches for is grey.
class RadioDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace usar::widgets
