#include "widgets/panels/plot_canvas.h"

#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include "widgets/models/parameter_display.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// Adds some margin around `range`, and a height if it has none.
QCPRange roomy(const QCPRange& range) {
    const double air = range.size() > 0.0 ? 0.08 * range.size() : std::max(0.5, 0.05 * std::abs(range.lower));
    return {range.lower - air, range.upper + air};
}

} // namespace

PlotCanvas::PlotCanvas(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
    laidOut(new QVBoxLayout(this), {}, -1, {plot_});
    setFocusProxy(plot_);
    plot_->setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Plot over protocol time"));
    setAccessibleDescription(tr("Values over protocol time, hours:minutes:seconds. Drag or use the arrow keys to move "
                                "in time, the wheel or plus and minus to zoom, Space to pause, F to follow."));
    plot_->setAccessibleName(accessibleName());
    plot_->setAccessibleDescription(accessibleDescription());
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setPlottingHint(QCP::phFastPolylines);
    plot_->axisRect()->setRangeDrag(Qt::Horizontal);
    plot_->axisRect()->setRangeZoom(Qt::Horizontal);
    plot_->axisRect()->setRangeZoomAxes({plot_->xAxis}, {plot_->yAxis, plot_->yAxis2});
    plot_->xAxis->setTicker(QSharedPointer<QCPAxisTickerTime>::create());
    plot_->xAxis->setRange(0.0, window_.count());
    chooseTimeFormat();
    plot_->yAxis->setNumberFormat(QStringLiteral("gb"));
    plot_->yAxis2->setNumberFormat(QStringLiteral("gb"));
    plot_->legend->setVisible(false);
    // Decimal points in every locale, like everywhere in the window.
    plot_->setLocale(QLocale::c());
    makeCursor();
    connectGestures();
    applyTheme();
    onThemeChange(this, [this] {
        applyTheme();
        plot_->replot(QCustomPlot::rpQueuedReplot);
    });
}

void PlotCanvas::connectGestures() {
    connect(plot_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, [this] {
        chooseTimeFormat();
        fitValues();
    });
    connect(plot_, &QCustomPlot::mouseWheel, this, [this](QWheelEvent* event) { aimWheel(event->position()); });
    connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
        moveCursor(event->position());
        if (event->buttons() & Qt::LeftButton)
            leaveFollowing();
    });
    connect(plot_, &QCustomPlot::mouseDoubleClick, this, [this] {
        values_fitted_ = true;
        setFollowing(true);
        emit followingChanged(true);
        plot_->replot();
    });
}

void PlotCanvas::makeCursor() {
    cursor_line_ = new QCPItemStraightLine(plot_); // The plot owns it.
    for (QCPItemPosition* end : {cursor_line_->point1, cursor_line_->point2}) {
        end->setTypeX(QCPItemPosition::ptAbsolute);
        end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    cursor_line_->setLayer(QStringLiteral("overlay")); // Moving it draws no curve again.
    cursor_line_->setSelectable(false);
    cursor_line_->setVisible(false);
    plot_->installEventFilter(this);
}

void PlotCanvas::moveCursor(const QPointF& at_px) {
    cursor_px_ = plot_->axisRect()->rect().contains(at_px.toPoint()) ? std::optional(at_px.x()) : std::nullopt;
    cursor_line_->setVisible(cursor_px_.has_value());
    cursor_line_->point1->setCoords(at_px.x(), 0.0);
    cursor_line_->point2->setCoords(at_px.x(), 1.0);
    plot_->layer(QStringLiteral("overlay"))->replot();
    emit cursorMoved();
}

std::optional<Seconds> PlotCanvas::cursor() const {
    return cursor_px_ ? std::optional(Seconds(plot_->xAxis->pixelToCoord(*cursor_px_))) : std::nullopt;
}

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Leave)
        moveCursor({-1.0, -1.0});
    return QWidget::eventFilter(watched, event);
}

void PlotCanvas::leaveFollowing() {
    if (!following_)
        return;
    following_ = false;
    emit followingChanged(false);
}

// Called before QCustomPlot handles the wheel itself.
void PlotCanvas::aimWheel(const QPointF& at_px) {
    QCPAxisRect* rect = plot_->axisRect();
    QCPAxis* axis = at_px.x() < rect->left() ? plot_->yAxis : at_px.x() > rect->right() ? plot_->yAxis2 : nullptr;
    rect->setRangeZoom(axis ? Qt::Vertical : Qt::Horizontal);
    if (!axis)
        return leaveFollowing();
    rect->setRangeZoomAxes({plot_->xAxis}, {axis});
    values_fitted_ = false;
}

void PlotCanvas::show(const SeriesStore& store) {
    matchLines(store);
    for (const Series& series : store.series())
        feed(series);
    assignAxes(store);
    oldest_s_ = store.oldestTime_s();
    newest_s_ = store.newestTime_s();
    if (following_)
        fitTime();
    fitValues();
    plot_->replot();
}

void PlotCanvas::dropLines(const SeriesStore& store) {
    matchLines(store);
    plot_->replot();
}

void PlotCanvas::matchLines(const SeriesStore& store) {
    std::vector<std::string> paths;
    for (const Series& series : store.series())
        paths.push_back(series.path);
    if (paths == order_)
        return;
    std::erase_if(lines_, [&](const auto& line) {
        const bool gone = std::ranges::find(paths, line.first) == paths.end();
        return gone && plot_->removeGraph(line.second.graph);
    });
    for (const std::string& path : paths)
        if (!lines_.contains(path))
            lines_[path].graph = plot_->addGraph();
    order_ = std::move(paths);
    styleLines();
}

void PlotCanvas::feed(const Series& series) {
    Line& line = lines_[series.path];
    if (line.history != series.history) {
        line.graph->data()->clear();
        line.history = series.history;
        line.taken = 0;
    }
    const double factor = displayUnit(series.unit).factor;
    const std::uint64_t known = line.taken > series.dropped ? line.taken - series.dropped : 0;
    QVector<QCPGraphData> fresh;
    fresh.reserve(static_cast<qsizetype>(series.samples.size() - known));
    for (std::size_t i = known; i < series.samples.size(); ++i)
        fresh.emplace_back(series.samples[i].time_s, series.samples[i].value * factor);
    line.graph->data()->add(fresh, true);
    line.taken = series.dropped + series.samples.size();
    if (!series.samples.empty())
        line.graph->data()->removeBefore(series.samples.front().time_s);
}

void PlotCanvas::assignAxes(const SeriesStore& store) {
    std::vector<QString> units;
    bool second_used = false;
    for (const Series& series : store.series()) {
        const QString unit = displayUnit(series.unit).text;
        if (std::ranges::find(units, unit) == units.end())
            units.push_back(unit);
        const bool second = units.size() > 1 && unit == units[1];
        second_used = second_used || second;
        lines_[series.path].graph->setValueAxis(second ? plot_->yAxis2 : plot_->yAxis);
    }
    QStringList left;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (i != 1 && !units[i].isEmpty())
            left << units[i];
    plot_->yAxis->setLabel(left.join(QStringLiteral(", ")));
    plot_->yAxis2->setLabel(second_used ? units[1] : QString());
    plot_->yAxis2->setVisible(second_used);
    plot_->yAxis2->setTickLabels(second_used);
}

void PlotCanvas::setWindow(Seconds window) {
    window_ = window;
    setFollowing(true);
}

void PlotCanvas::setFollowing(bool following) {
    following_ = following;
    if (!following)
        return;
    fitTime();
    fitValues();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

// Until the window is full of samples, the line grows from the left edge.
void PlotCanvas::fitTime() {
    if (!newest_s_ || !oldest_s_)
        return;
    const double span = std::isfinite(window_.count()) ? window_.count() : std::max(1.0, *newest_s_ - *oldest_s_);
    const double from = std::max(*oldest_s_, *newest_s_ - span);
    plot_->xAxis->setRange(from, from + span);
}

void PlotCanvas::fitValues() {
    if (!values_fitted_)
        return;
    fitAxis(plot_->yAxis);
    fitAxis(plot_->yAxis2);
}

void PlotCanvas::fitAxis(QCPAxis* axis) {
    std::optional<QCPRange> all;
    for (const QCPGraph* graph : axis->graphs()) {
        bool found = false;
        const QCPRange range = graph->getValueRange(found, QCP::sdBoth, plot_->xAxis->range());
        if (found)
            all = all ? all->expanded(range) : range;
    }
    if (all)
        axis->setRange(roomy(*all));
}

void PlotCanvas::emphasize(const std::set<std::string>& paths) {
    emphasized_ = paths;
    styleLines();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::zoomTime(double factor) {
    leaveFollowing();
    plot_->xAxis->scaleRange(1.0 / factor);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::panTime(double fraction) {
    leaveFollowing();
    plot_->xAxis->moveRange(fraction * plot_->xAxis->range().size());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

Seconds PlotCanvas::visibleFrom() const {
    return Seconds(plot_->xAxis->range().lower);
}

Seconds PlotCanvas::visibleTo() const {
    return Seconds(plot_->xAxis->range().upper);
}

int PlotCanvas::sampleCount(const std::string& path) const {
    const auto found = lines_.find(path);
    return found == lines_.end() ? 0 : found->second.graph->dataCount();
}

QPixmap PlotCanvas::picture() const {
    plot_->legend->setVisible(true);
    cursor_line_->setVisible(false);
    QPixmap picture = plot_->toPixmap(0, 0, 2.0);
    plot_->legend->setVisible(false);
    cursor_line_->setVisible(cursor_px_.has_value());
    plot_->replot(QCustomPlot::rpQueuedReplot);
    return picture;
}

QColor PlotCanvas::lineColor(int index) {
    const Tokens& t = tokens();
    QColor color = robotColor(index + 1);
    for (int i = 0; i < 8 && contrast(color, t.surface) < 3.0; ++i)
        color = currentTheme() == Theme::Light ? color.darker(115) : color.lighter(115);
    return color;
}

void PlotCanvas::applyTheme() {
    const Tokens& t = tokens();
    plot_->setBackground(QBrush(t.surface));
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis, plot_->yAxis2})
        styleAxis(axis);
    cursor_line_->setPen(QPen(t.text_muted, 1.0));
    plot_->legend->setBrush(t.raised);
    plot_->legend->setBorderPen(QPen(t.line));
    plot_->legend->setTextColor(t.text);
    plot_->legend->setFont(themeFont(FontRole::Small));
    plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
    styleLines();
}

void PlotCanvas::styleAxis(QCPAxis* axis) {
    const Tokens& t = tokens();
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

// Colors repeat after nine lines; the next nine lines are dashed.
void PlotCanvas::styleLines() {
    int index = 0;
    for (const std::string& path : order_) {
        QPen pen(lineColor(index), emphasized_.contains(path) ? 2.5 : 1.0);
        pen.setStyle(index / 9 % 2 == 0 ? Qt::SolidLine : Qt::DashLine);
        lines_[path].graph->setPen(pen);
        lines_[path].graph->setName(QString::fromStdString(path));
        ++index;
    }
}

void PlotCanvas::chooseTimeFormat() {
    const auto ticker = plot_->xAxis->ticker().dynamicCast<QCPAxisTickerTime>();
    const bool fine = plot_->xAxis->range().size() < 5.0;
    ticker->setTimeFormat(fine ? QStringLiteral("%m:%s.%z") : QStringLiteral("%h:%m:%s"));
}

} // namespace usar::widgets
