#include "widgets/messages/completion_delegate.h"

#include <QPainter>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int word_width_px = 170;

} // namespace

void CompletionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const Tokens& t = tokens();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->fillRect(option.rect, selected ? t.accent : t.raised);
    const QRect row = option.rect.adjusted(gap::small, 0, -gap::small, 0);
    const QString word = index.data().toString();
    painter->setFont(codeFont());
    painter->setPen(selected ? inkOn(t.accent) : t.text);
    painter->drawText(row, Qt::AlignVCenter | Qt::AlignLeft, word);
    const int word_px = std::max(word_width_px, painter->fontMetrics().horizontalAdvance(word) + gap::medium);
    painter->setFont(themeFont());
    painter->setPen(selected ? inkOn(t.accent) : t.text_muted);
    const QRect rest = row.adjusted(word_px, 0, 0, 0);
    const QString help =
        painter->fontMetrics().elidedText(index.data(help_role).toString(), Qt::ElideRight, rest.width());
    painter->drawText(rest, Qt::AlignVCenter | Qt::AlignLeft, help);
    painter->restore();
}

QSize CompletionDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
    return {word_width_px, minimum_target};
}

} // namespace usar::widgets
