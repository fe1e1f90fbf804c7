#include "widgets/panels/plot_pane.h"

#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "widgets/models/parameter_display.h"
#include "widgets/models/plot/plot_texts.h"

namespace usar::widgets {

namespace {

/// Adds some margin around `range`, and a height if it has none.
QCPRange roomy(const QCPRange& range) {
    const double air = range.size() > 0.0 ? 0.08 * range.size() : std::max(0.5, 0.05 * std::abs(range.lower));
    return {range.lower - air, range.upper + air};
}

} // namespace

void stylePlotAxis(QCPAxis* axis, const Tokens& t) {
    const QPen line(t.line);
    axis->setBasePen(line);
    axis->setTickPen(line);
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(t.text_muted);
    axis->setTickLabelFont(themeFont(FontRole::Small));
    axis->setLabelColor(t.text_muted);
    axis->setLabelFont(themeFont(FontRole::Small));
    QColor faint = t.line;
    faint.setAlpha(110);
    axis->grid()->setPen(QPen(faint));
    axis->grid()->setZeroLinePen(QPen(t.line));
}

QColor plotLineColor(int index, Theme theme) {
    QColor color = robotColor(index + 1);
    for (int i = 0; i < 8 && contrast(color, tokens(theme).surface) < 3.0; ++i)
        color = theme == Theme::Light ? color.darker(115) : color.lighter(115);
    return color;
}

PlotPane::PlotPane(QCustomPlot& plot, QCPMarginGroup& sides, int row)
    : plot_(plot)
    , rect_(new QCPAxisRect(&plot, true)) {
    plot.plotLayout()->addElement(row, 0, rect_);
    rect_->setMarginGroup(QCP::msLeft | QCP::msRight, &sides);
    rect_->setMinimumMargins({12, 6, 12, 6});
    rect_->setMinimumSize(40, 24);
    rect_->setRangeDrag(Qt::Horizontal);
    rect_->setRangeZoom(Qt::Horizontal);
    values_ = {rect_->axis(QCPAxis::atLeft), rect_->axis(QCPAxis::atRight)};
    for (QCPAxis* axis : values_)
        axis->setNumberFormat(QStringLiteral("gb"));
    for (QCPAxis* axis : rect_->axes()) {
        axis->setLayer(QStringLiteral("axes"));
        axis->grid()->setLayer(QStringLiteral("grid"));
    }
    rect_->setRangeZoomAxes({timeAxis()}, values_[0] ? QList{values_[0]} : QList<QCPAxis*>{});
}

PlotPane::~PlotPane() {
    for (QCPGraph* graph : graphs_)
        plot_.removeGraph(graph);
    plot_.plotLayout()->remove(rect_);
}

QCPAxis* PlotPane::timeAxis() const {
    return rect_->axis(QCPAxis::atBottom);
}

QCPAxis* PlotPane::valueAxis() const {
    return values_[0];
}

void PlotPane::setSeries(std::vector<ShownSeries> series) {
    while (graphs_.size() > series.size()) {
        plot_.removeGraph(graphs_.back());
        graphs_.pop_back();
    }
    while (graphs_.size() < series.size())
        graphs_.push_back(plot_.addGraph(timeAxis(), valueAxis()));
    series_ = std::move(series);
    for (QCPGraph* graph : graphs_) {
        graph->setAdaptiveSampling(false); // The points are as few as the screen has columns already.
        graph->setSelectable(QCP::stNone);
    }
    assignAxes();
}

void PlotPane::assignAxes() {
    std::vector<QString> units;
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const QString unit = displayUnit(series_[i].series->unit).text;
        auto found = std::ranges::find(units, unit);
        if (found == units.end())
            found = units.insert(units.end(), unit);
        const auto axis = static_cast<std::size_t>(found - units.begin());
        while (values_.size() <= axis) {
            values_.push_back(rect_->addAxis(QCPAxis::atRight));
            values_.back()->setNumberFormat(QStringLiteral("gb"));
            values_.back()->setLayer(QStringLiteral("axes"));
            values_.back()->grid()->setVisible(false);
        }
        graphs_[i]->setValueAxis(values_[axis]);
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
        const bool used = i == 0 || i < units.size();
        values_[i]->setVisible(used);
        values_[i]->setTickLabels(used);
        values_[i]->setLabel(i < units.size() ? units[i] : QString());
    }
}

void PlotPane::fill(double until_s, int columns) {
    const QCPRange time = timeAxis()->range();
    bool unit_learned = false;
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const Series& series = *series_[i].series;
        const DisplayUnit unit = displayUnit(series.unit);
        unit_learned = unit_learned || unit.text != graphs_[i]->valueAxis()->label();
        QVector<QCPGraphData> points;
        for (const Sample& sample : series.samples.curve(time.lower, std::min(time.upper, until_s), columns))
            if (sample.time_s <= until_s)
                points.emplace_back(sample.time_s, sample.value * unit.factor);
        graphs_[i]->data()->set(points, true);
    }
    if (unit_learned) // The first value of a series tells its unit.
        assignAxes();
    fitValues();
}

void PlotPane::fitValues() {
    if (values_fitted_)
        for (QCPAxis* axis : values_)
            fitAxis(axis);
}

void PlotPane::fitAxis(QCPAxis* axis) {
    std::optional<QCPRange> all;
    for (const QCPGraph* graph : axis->graphs()) {
        bool found = false;
        const QCPRange range = graph->getValueRange(found, QCP::sdBoth, timeAxis()->range());
        if (found)
            all = all ? all->expanded(range) : range;
    }
    if (all)
        axis->setRange(roomy(*all));
}

bool PlotPane::aimWheel(const QPointF& at_px) {
    QCPAxis* axis = nullptr;
    if (at_px.x() < rect_->left())
        axis = values_[0];
    double beyond_px = at_px.x() - rect_->right();
    for (std::size_t i = 1; i < values_.size() && beyond_px > 0.0; ++i)
        if (values_[i]->visible() && values_[i]->offset() <= beyond_px)
            axis = values_[i];
    rect_->setRangeZoom(axis ? Qt::Vertical : Qt::Horizontal);
    if (!axis)
        return false;
    rect_->setRangeZoomAxes({timeAxis()}, {axis});
    values_fitted_ = false;
    return true;
}

void PlotPane::setTimesShown(bool shown) {
    timeAxis()->setTickLabels(shown);
}

// Colors repeat after nine lines; the next nine lines are dashed.
void PlotPane::style(Theme theme, const std::set<SeriesKey>& emphasized) {
    const Tokens& t = tokens(theme);
    for (QCPAxis* axis : rect_->axes())
        stylePlotAxis(axis, t);
    if (chosen_)
        valueAxis()->setBasePen(QPen(t.accent, 3.0));
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const int color = series_[i].color;
        QPen pen(plotLineColor(color, theme), emphasized.contains(series_[i].key) ? 2.5 : 1.0);
        pen.setStyle(color / 9 % 2 == 0 ? Qt::SolidLine : Qt::DashLine);
        graphs_[i]->setPen(pen);
    }
}

QCPLegend* PlotPane::addLegend(int row, Theme theme) {
    const Tokens& t = tokens(theme);
    auto* legend = new QCPLegend; // The layout of the plot owns it.
    plot_.plotLayout()->addElement(row, 1, legend);
    legend->setLayer(QStringLiteral("legend"));
    legend->setBrush(Qt::NoBrush);
    legend->setBorderPen(Qt::NoPen);
    legend->setTextColor(t.text);
    legend->setFont(themeFont(FontRole::Small));
    legend->setFillOrder(QCPLayoutGrid::foRowsFirst);
    for (std::size_t i = 0; i < series_.size(); ++i) {
        const QString unit = displayUnit(series_[i].series->unit).text;
        graphs_[i]->setName(labelOf(series_[i].key) + (unit.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(unit)));
        graphs_[i]->addToLegend(legend);
    }
    return legend;
}

int PlotPane::pointCount(const SeriesKey& key) const {
    const auto found = std::ranges::find(series_, key, &ShownSeries::key);
    return found == series_.end() ? 0 : graphs_[static_cast<std::size_t>(found - series_.begin())]->dataCount();
}

} // namespace usar::widgets
