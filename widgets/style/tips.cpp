#include "widgets/style/tips.h"

#include <limits>

#include <QCoreApplication>

namespace usar::widgets {

namespace {

void tell(QWidget* control, const QString& what, const QString& range) {
    const QString tip = what + u'\n' + range;
    if (control->toolTip() != tip) // Ranges of replays grow many times a second.
        control->setToolTip(tip);
}

QString unitOf(const QString& unit, const QString& suffix) {
    return unit.isEmpty() || !suffix.isEmpty() ? suffix : QChar(0x00a0) + unit;
}

} // namespace

QString withoutTrailingZeros(QString number) {
    if (number.contains(u'.')) {
        while (number.endsWith(u'0'))
            number.chop(1);
        if (number.endsWith(u'.'))
            number.chop(1);
    }
    return number == QStringLiteral("-0") ? QStringLiteral("0") : number;
}

QString rangeText(const QString& lowest, const QString& highest) {
    return highest.isEmpty() ? QCoreApplication::translate("Tips", "Range: from %1").arg(lowest)
                             : QCoreApplication::translate("Tips", "Range: %1 to %2").arg(lowest, highest);
}

void tellRange(QDoubleSpinBox* box, const QString& what, QString unit) {
    unit = unitOf(unit, box->suffix());
    const auto text = [&](double value) { return withoutTrailingZeros(box->textFromValue(value)) + unit; };
    tell(box, what, rangeText(text(box->minimum()), text(box->maximum())));
}

void tellRange(QSpinBox* box, const QString& what, QString unit) {
    unit = unitOf(unit, box->suffix());
    const bool endless = box->maximum() == std::numeric_limits<int>::max();
    tell(box, what,
         rangeText(QString::number(box->minimum()) + unit,
                   endless ? QString() : QString::number(box->maximum()) + unit));
}

void tellRange(QSlider* slider, const QString& what, const QString& lowest, const QString& highest) {
    tell(slider, what, rangeText(lowest, highest));
}

} // namespace usar::widgets
