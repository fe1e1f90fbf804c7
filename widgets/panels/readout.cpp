#include "widgets/panels/readout.h"

#include <QPainter>

#include "widgets/style/theme.h"

namespace usar::widgets {

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

} // namespace usar::widgets
