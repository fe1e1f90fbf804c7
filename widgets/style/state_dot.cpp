#include "widgets/style/state_dot.h"

#include <QPainter>

#include "widgets/style/theme.h"

namespace usar::widgets {

StateDot::StateDot(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StateDot::setState(StateShape state) {
    state_ = state;
    update();
}

QColor stateColor(StateShape state) {
    const Tokens& t = tokens();
    const QColor colors[] = {t.text_muted, t.accent, t.ok, t.caution, t.danger};
    return colors[static_cast<std::size_t>(state)];
}

void StateDot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(width() / 2.0, height() / 2.0);
    const QColor color = stateColor(state_);
    const QRectF circle(-5.0, -5.0, 10.0, 10.0);
    painter.setPen(QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    switch (state_) {
    case StateShape::Off:
        painter.drawEllipse(circle);
        break;
    case StateShape::Busy:
        painter.drawEllipse(circle);
        painter.setBrush(color);
        painter.drawChord(circle, 90 * 16, 180 * 16);
        break;
    case StateShape::Good:
        painter.setBrush(color);
        painter.drawEllipse(circle);
        break;
    case StateShape::Waiting:
        painter.drawPolygon(QPolygonF({{0.0, -5.5}, {6.0, 5.0}, {-6.0, 5.0}}));
        break;
    case StateShape::Bad:
        painter.drawEllipse(circle);
        painter.drawLine(QPointF(-2.0, -2.0), QPointF(2.0, 2.0));
        painter.drawLine(QPointF(2.0, -2.0), QPointF(-2.0, 2.0));
        break;
    }
}

} // namespace usar::widgets
