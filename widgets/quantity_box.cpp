#include "widgets/quantity_box.h"

#include <QWheelEvent>

#include "core/base/numbers.h"
#include "widgets/theme.h"

namespace usar::widgets {

QuantityBox::QuantityBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(false);
    setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setMinimumHeight(minimum_target);
}

QString QuantityBox::textFromValue(double value) const {
    QString text = QString::fromStdString(fixed(value, decimals()));
    if (text.contains(u'.')) {
        while (text.endsWith(u'0'))
            text.chop(1);
        if (text.endsWith(u'.'))
            text.chop(1);
    }
    return text == QStringLiteral("-0") ? QStringLiteral("0") : text;
}

double QuantityBox::valueFromText(const QString& text) const {
    QString number = text;
    if (!suffix().isEmpty() && number.endsWith(suffix()))
        number.chop(suffix().size());
    number.replace(u',', u'.');
    return readNumber(number.toStdString()).value_or(value());
}

QValidator::State QuantityBox::validate(QString& text, int& position) const {
    text.replace(u',', u'.');
    return QDoubleSpinBox::validate(text, position);
}

void QuantityBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace usar::widgets
