#include "widgets/style/elided_label.h"

#include <QPainter>

namespace usar::widgets {

QString fittedText(const QString& text, const QFontMetrics& metrics, int width_px) {
    QString shown = text;
    for (auto part = shown.lastIndexOf(u" · "); part > 0 && metrics.horizontalAdvance(shown) > width_px;
         part = shown.lastIndexOf(u" · "))
        shown.truncate(part);
    return metrics.elidedText(shown, Qt::ElideRight, width_px);
}

QSize ElidedLabel::sizeHint() const {
    const QSize hint = QLabel::sizeHint();
    return room_for_.isEmpty() ? hint : QSize(fontMetrics().horizontalAdvance(room_for_), hint.height());
}

void ElidedLabel::setRoomFor(const QString& text) {
    room_for_ = text;
    updateGeometry();
}

void ElidedLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const QRect room = contentsRect();
    painter.drawText(room, static_cast<int>(alignment() | Qt::TextSingleLine),
                     fittedText(text(), fontMetrics(), room.width()));
}

} // namespace usar::widgets
