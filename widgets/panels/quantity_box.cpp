#include "widgets/panels/quantity_box.h"

#include <algorithm>
#include <cmath>

#include <QWheelEvent>

#include "core/base/numbers.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

QuantityBox::QuantityBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(false);
    setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setMinimumHeight(minimum_target);
}

QString QuantityBox::textFromValue(double value) const {
    return withoutTrailingZeros(QString::fromStdString(fixed(value, decimals())));
}

QString QuantityBox::numberIn(QString text) const {
    if (!suffix().isEmpty() && text.endsWith(suffix()))
        text.chop(suffix().size());
    return text.replace(u',', u'.').trimmed();
}

bool QuantityBox::isSpecial(const QString& text) const {
    return !specialValueText().isEmpty() && text == specialValueText();
}

double QuantityBox::valueFromText(const QString& text) const {
    if (isSpecial(text))
        return minimum();
    return std::clamp(readNumber(numberIn(text).toStdString()).value_or(value()), minimum(), maximum());
}

// Qt's own box refuses keys that would leave the range and replaces invalid text by zero; users could not type a number
// and see it being clamped.
QValidator::State QuantityBox::validate(QString& text, int&) const {
    if (isSpecial(text))
        return QValidator::Acceptable;
    const QString number = numberIn(text);
    if (const auto value = readNumber(number.toStdString()); value && std::isfinite(*value))
        return QValidator::Acceptable;
    const QString signs = QStringLiteral("+-.0123456789");
    const bool may_become_one = std::ranges::all_of(number, [&](QChar c) { return signs.contains(c); });
    return may_become_one ? QValidator::Intermediate : QValidator::Invalid;
}

void QuantityBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace usar::widgets
