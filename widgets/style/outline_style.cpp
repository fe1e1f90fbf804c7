#include "widgets/style/outline_style.h"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

void outline(QPainter& painter, const QRect& rect, const QColor& ink) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 1.0));
    painter.drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
    painter.restore();
}

QColor checkBoxInk(QStyle::State state) {
    if (!(state & QStyle::State_Enabled))
        return tokens().line;
    return state & QStyle::State_HasFocus ? tokens().accent : tokens().text_muted;
}

/// In the light theme Fusion's own hairline is dark enough, and the focused widget has a ring.
bool needsHairline(const QStyleOption& option) {
    return currentTheme() == Theme::Dark && !(option.state & QStyle::State_HasFocus);
}

} // namespace

OutlineStyle::OutlineStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void OutlineStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox)
        outline(*painter, option->rect, checkBoxInk(option->state));
    else if (element == PE_FrameLineEdit && needsHairline(*option))
        outline(*painter, option->rect, tokens().line);
}

void OutlineStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                      const QWidget* widget) const {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_SpinBox && needsHairline(*option))
        outline(*painter, option->rect, tokens().line);
}

} // namespace usar::widgets
