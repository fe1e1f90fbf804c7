#include "widgets/campaign/histogram_view.h"

#include <chrono>

#include <QBoxLayout>
#include <QTimer>

#include <qcustomplot.h>

#include "widgets/panels/plot_pane.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

HistogramView::HistogramView(const RunTable& table, QWidget* parent)
    : QWidget(parent)
    , table_(table)
    , plot_(new QCustomPlot(this)) {
    named(metric_, tr("Figure"), tr("The figure that is counted"));
    metric_->setMinimumHeight(minimum_target);
    metric_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    named(legend_, tr("Variants"), tr("The colors of the variants"));
    legend_->setTextFormat(Qt::RichText);
    legend_->setWordWrap(true);
    plot_->setAccessibleName(tr("Histogram"));
    plot_->setMinimumHeight(80);
    plot_->xAxis->grid()->setVisible(false);
    const QSharedPointer<QCPAxisTickerFixed> whole(new QCPAxisTickerFixed); // Runs are counted in whole ones.
    whole->setTickStep(1.0);
    whole->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    plot_->yAxis->setTicker(whole);
    auto* const head = laidOut(new QHBoxLayout, gap::small, {metric_, legend_});
    head->setStretchFactor(legend_, 1);
    auto* const column = laidOut(new QVBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::small}, gap::tiny);
    column->addLayout(head);
    column->addWidget(plot_, 1);
    nothing_ = new EmptyState(plot_, tr("Nothing to count yet"),
                              tr("How often each value came out is drawn here for each variant, as runs end."));
    connect(&table_, &QAbstractItemModel::modelReset, this, &HistogramView::listMetrics);
    connect(&table_, &QAbstractItemModel::rowsInserted, this, &HistogramView::drawSoon);
    connect(metric_, &QComboBox::currentIndexChanged, this, &HistogramView::draw);
    onThemeChange(this, [this] { draw(); });
    listMetrics();
}

HistogramView::~HistogramView() = default;

void HistogramView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    draw();
}

void HistogramView::listMetrics() {
    QStringList titles;
    for (const CampaignMetric& metric : table_.metrics())
        titles << metric.title;
    QStringList shown;
    for (int i = 0; i < metric_->count(); ++i)
        shown << metric_->itemText(i);
    if (titles != shown) {
        const QSignalBlocker quiet(metric_);
        metric_->clear();
        metric_->addItems(titles);
    }
    drawSoon();
}

void HistogramView::drawSoon() {
    if (due_ || !isVisible())
        return;
    due_ = true;
    QTimer::singleShot(std::chrono::milliseconds(150), this, &HistogramView::draw);
}

void HistogramView::draw() {
    due_ = false;
    const int metric = metric_->currentIndex();
    histogram_ = metric >= 0 ? histogramOf(table_.runs(), static_cast<std::size_t>(metric)) : RunHistogram{};
    nothing_->setVisible(histogram_.bins == 0);
    writeLegend();
    drawBars();
}

void HistogramView::drawBars() {
    plot_->clearPlottables();
    plot_->setBackground(tokens().surface);
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis})
        stylePlotAxis(axis, tokens());
    auto* const group = new QCPBarsGroup(plot_);
    group->setSpacing(0.0);
    const auto count = static_cast<double>(std::max<std::size_t>(1, histogram_.variants.size()));
    for (int i = 0; const VariantCounts& one : histogram_.variants) {
        const QColor color = plotLineColor(i++, currentTheme());
        auto* const bars = new QCPBars(plot_->xAxis, plot_->yAxis);
        auto* const not_done = new QCPBars(plot_->xAxis, plot_->yAxis); // They stand on those that were.
        for (QCPBars* const part : {bars, not_done}) {
            part->setWidth(0.9 * histogram_.width / count);
            part->setBarsGroup(group);
        }
        bars->setPen(Qt::NoPen);
        bars->setBrush(color);
        not_done->setPen(color);
        not_done->setBrush(QBrush(color, Qt::BDiagPattern));
        not_done->moveAbove(bars);
        for (int bin = 0; bin < histogram_.bins; ++bin) {
            bars->addData(histogram_.middle(bin), one.counts[static_cast<std::size_t>(bin)]);
            if (const int more = one.not_done[static_cast<std::size_t>(bin)]; more > 0)
                not_done->addData(histogram_.middle(bin), more);
        }
    }
    if (histogram_.bins > 0) {
        const CampaignMetric& metric = table_.metrics()[static_cast<std::size_t>(metric_->currentIndex())];
        plot_->xAxis->setLabel(metric.unit.isEmpty() ? metric.title : metric.title + " [" + metric.unit + ']');
        plot_->yAxis->setLabel(tr("runs"));
        plot_->xAxis->setRange(histogram_.from, histogram_.from + histogram_.bins * histogram_.width);
        plot_->yAxis->setRange(0.0, std::max(1.0, 1.08 * histogram_.highest()));
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void HistogramView::writeLegend() {
    QStringList parts;
    int unknown = 0;
    for (int i = 0; const VariantCounts& one : histogram_.variants) {
        parts << QStringLiteral("<span style='color:%1'>■</span> %2")
                     .arg(plotLineColor(i++, currentTheme()).name(), one.variant.toHtmlEscaped());
        unknown += one.unknown;
    }
    if (histogram_.anyNotDone())
        parts << tr("hatched: runs that were not done");
    if (unknown > 0)
        parts << tr("%1 runs without this figure").arg(unknown);
    legend_->setText(parts.join(QStringLiteral("&nbsp;&nbsp; ")));
}

} // namespace usar::widgets
