#include "widgets/models/figures.h"

#include <cmath>

#include "core/base/numbers.h"

namespace usar::widgets {

namespace {
const QString none = QStringLiteral("–");
constexpr QChar figure_space(0x2007);
constexpr QChar minus_sign(0x2212);
} // namespace

QString figure(double value, int decimals, int width) {
    if (!std::isfinite(value))
        return none.rightJustified(width, figure_space);
    QString text = QString::fromStdString(fixed(std::abs(value), decimals));
    const bool zero = text.count(u'0') + text.count(u'.') == text.size();
    if (value < 0.0 && !zero)
        text.prepend(minus_sign);
    return text.rightJustified(width, figure_space);
}

QString clockText(Seconds duration) {
    if (!std::isfinite(duration.count()) || duration.count() < 0.0)
        return none;
    const auto s = static_cast<long long>(duration.count());
    return QStringLiteral("%1:%2:%3")
        .arg(s / 3600, 2, 10, QChar(u'0'))
        .arg(s / 60 % 60, 2, 10, QChar(u'0'))
        .arg(s % 60, 2, 10, QChar(u'0'));
}

QString durationText(Seconds duration) {
    if (!std::isfinite(duration.count()) || duration.count() < 0.0)
        return none;
    const auto s = std::llround(duration.count());
    if (s < 60)
        return QStringLiteral("%1 s").arg(s);
    if (s < 3600)
        return QStringLiteral("%1 min %2 s").arg(s / 60).arg(s % 60, 2, 10, QChar(u'0'));
    return QStringLiteral("%1 h %2 min").arg(s / 3600).arg(s / 60 % 60, 2, 10, QChar(u'0'));
}

QString ageText(Seconds age) {
    const double s = age.count();
    if (!std::isfinite(s))
        return none;
    if (s < 9.95)
        return figure(std::max(0.0, s), 1) + QStringLiteral(" s");
    if (s < 99.5)
        return QStringLiteral("%1 s").arg(std::llround(s));
    if (s < 5970.0)
        return QStringLiteral("%1 min").arg(std::llround(s / 60.0));
    return QStringLiteral("%1 h").arg(std::llround(s / 3600.0));
}

} // namespace usar::widgets
