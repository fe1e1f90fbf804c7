#include "widgets/panels/readout.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

/// All captions get this width, so that the bars of meters below each other are aligned.
const QString widest_caption = QStringLiteral("Battery used");

} // namespace

Readout::Readout(const QString& caption, const QString& unit, const QString& sample, QWidget* parent)
    : Instrument(parent)
    , caption_(caption)
    , unit_(unit)
    , sample_(sample) {
    setAccessibleName(caption);
    setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
    setText(QStringLiteral("–"));
}

void Readout::setText(const QString& text) {
    if (text == text_)
        return;
    text_ = text;
    setAccessibleDescription(text + QStringLiteral(" ") + unit_);
    update();
}

int Readout::fieldWidth_px() const {
    return std::max(QFontMetrics(themeFont(FontRole::Big)).horizontalAdvance(sample_),
                    QFontMetrics(themeFont(FontRole::Small)).horizontalAdvance(caption_));
}

QSize Readout::sizeHint() const {
    const QFontMetrics big(themeFont(FontRole::Big));
    const QFontMetrics small(themeFont(FontRole::Small));
    return {fieldWidth_px() + gap::tiny + small.horizontalAdvance(unit_) + 2, big.height() + small.height()};
}

void Readout::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens();
    QPainter painter(this);
    QFont big = themeFont(FontRole::Big);
    const QFont small = themeFont(FontRole::Small);
    const QFontMetrics big_metrics(big);
    const QFontMetrics small_metrics(small);
    const int field = fieldWidth_px();
    big.setStrikeOut(stale());
    painter.setFont(big);
    painter.setPen(ink(t.text));
    painter.drawText(QRect(0, 0, field, big_metrics.height()), Qt::AlignRight | Qt::AlignVCenter, text_);
    painter.setFont(small);
    painter.setPen(t.text_muted);
    painter.drawText(QPoint(field + gap::tiny, big_metrics.ascent()), unit_);
    painter.drawText(QRect(0, big_metrics.height(), field, small_metrics.height()), Qt::AlignRight, caption_);
}

Meter::Meter(const QString& caption, QWidget* parent) : Instrument(parent), caption_(caption) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(caption);
    setValue(std::nullopt);
}

void Meter::setValue(std::optional<double> value_pct) {
    value_pct_ = value_pct;
    setAccessibleDescription(value_pct ? figure(*value_pct, 0) + QStringLiteral(" %") : tr("unknown"));
    update();
}

void Meter::setLimits(double caution_pct, double danger_pct) {
    caution_pct_ = caution_pct;
    danger_pct_ = danger_pct;
    update();
}

void Meter::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF words(0, 0, width(), height());
    const double value = value_pct_.value_or(qQNaN());
    const QColor ink = stale() ? t.stale : value >= danger_pct_ ? t.danger : value >= caution_pct_ ? t.caution : t.ok;
    painter.setPen(t.text_muted);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, caption_);
    QFont figures = font();
    figures.setStrikeOut(stale());
    painter.setFont(figures);
    painter.setPen(stale() || value >= caution_pct_ ? ink : t.text);
    // The strike-out also covers spaces, so a stale figure is not padded.
    const QString mark = value >= caution_pct_ && !stale() ? QStringLiteral("! ") : QString();
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     mark + figure(value, 0, stale() ? 0 : 3) + QStringLiteral(" %"));
    const double left = fontMetrics().horizontalAdvance(widest_caption) + gap::small;
    const double right = fontMetrics().horizontalAdvance(QStringLiteral("! 100 %")) + gap::small;
    const QRectF groove(left + 0.5, std::round(height() / 2.0) - 3.5, std::max(width() - left - right, 0.0), 7.0);
    painter.setPen(QPen(t.line, 1.0));
    painter.setBrush(value_pct_ ? QBrush(t.raised) : QBrush(t.line, Qt::BDiagPattern));
    painter.drawRoundedRect(groove, 3.0, 3.0);
    if (!value_pct_)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawRoundedRect(QRectF(groove.topLeft(), QSizeF(groove.width() * std::clamp(value / 100.0, 0.0, 1.0), 7.0)),
                            3.0, 3.0);
}

} // namespace usar::widgets
