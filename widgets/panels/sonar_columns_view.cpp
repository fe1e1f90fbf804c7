#include "widgets/panels/sonar_columns_view.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QColor riskColor(agent::Risk risk) {
    return risk == agent::Risk::None ? tokens().ok : risk == agent::Risk::Low ? tokens().caution : tokens().danger;
}

} // namespace

SonarColumnsView::SonarColumnsView(QWidget* parent) : Instrument(parent) {
    setAccessibleName(tr("Sonars"));
    setToolTip(tr("Range of each sonar in meters, from left to right as they are mounted on the robot. "
                  "Bands: high risk (dense) and low risk (light)."));
}

void SonarColumnsView::setColumns(const std::vector<SonarColumn>& columns) {
    columns_ = columns;
    const auto risky = std::ranges::count_if(columns_, [](const auto& c) { return c.risk != agent::Risk::None; });
    showFresh(columns_.empty() ? tr("No sonars yet") : tr("%1 sonars, %2 at risk").arg(columns_.size()).arg(risky));
}

void SonarColumnsView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (columns_.empty())
        return paintEmptySheet(painter, *this, tr("No sonars yet.\nOne column each appears here once they report."));
    paintSheet(painter, *this);
    paintSheetHead(painter, *this, tr("sonar, m"), {}, stale());
    const double top = sheetHead_px(*this);
    const double step = (width() - 2.0 * gap::tiny) / static_cast<double>(columns_.size());
    for (std::size_t i = 0; i < columns_.size(); ++i)
        paintColumn(painter, columns_[i],
                    QRectF(gap::tiny + static_cast<double>(i) * step, top, step, height() - top - 2.0));
}

void SonarColumnsView::paintColumn(QPainter& painter, const SonarColumn& column, const QRectF& cell) const {
    const Tokens& t = tokens();
    painter.setFont(themeFont(FontRole::Small));
    const double line = QFontMetricsF(painter.font()).height();
    const bool risky = column.risk != agent::Risk::None && !stale();
    const QRectF shaft = cell.adjusted(3.0, line + 2.0, -3.0, -2.0 * line - 2.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.raised);
    painter.drawRect(shaft);
    paintZones(painter, column, shaft);
    const double part = std::clamp(column.range_m / column.maximum_m, 0.0, 1.0);
    if (std::isfinite(column.range_m)) {
        const double bar = shaft.height() * part;
        painter.setBrush(faded(ink(riskColor(column.risk)), stale() ? 0.4 : 0.85));
        painter.setPen(Qt::NoPen);
        painter.drawRect(shaft.adjusted(shaft.width() * 0.22, shaft.height() - bar, -shaft.width() * 0.22, 0.0));
    }
    QFont font = painter.font();
    font.setStrikeOut(stale());
    painter.setFont(font);
    painter.setPen(ink(t.text));
    painter.drawText(QRectF(cell.left() - 4.0, cell.top(), cell.width() + 8.0, line), Qt::AlignCenter,
                     figure(column.range_m, column.range_m >= 10.0 ? 1 : 2));
    font.setStrikeOut(false);
    font.setBold(risky);
    painter.setFont(font);
    painter.setPen(risky ? riskColor(column.risk) : t.text_muted);
    painter.drawText(QRectF(cell.left() - 4.0, shaft.bottom() + 1.0, cell.width() + 8.0, line), Qt::AlignCenter,
                     column.name);
    if (risky)
        painter.drawText(QRectF(cell.left() - 4.0, shaft.bottom() + 1.0 + line, cell.width() + 8.0, line),
                         Qt::AlignCenter, riskWord(column.risk));
}

void SonarColumnsView::paintZones(QPainter& painter, const SonarColumn& column, const QRectF& shaft) const {
    const auto level = [&](double range_m) {
        return shaft.bottom() - shaft.height() * std::clamp(range_m / column.maximum_m, 0.0, 1.0);
    };
    if (!(column.low_risk_below_m > 0.0))
        return;
    const double high = level(column.high_risk_below_m);
    const double low = level(column.low_risk_below_m);
    const QColor danger = ink(tokens().danger);
    const QColor caution = ink(tokens().caution);
    painter.fillRect(QRectF(QPointF(shaft.left(), high), shaft.bottomRight()), faded(danger, 0.22));
    painter.fillRect(QRectF(QPointF(shaft.left(), low), QPointF(shaft.right(), high)), faded(caution, 0.40));
    painter.setPen(QPen(danger, 1.0));
    painter.drawLine(QPointF(shaft.left(), high), QPointF(shaft.right(), high));
    painter.setPen(QPen(caution, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(shaft.left(), low), QPointF(shaft.right(), low));
}

} // namespace usar::widgets
