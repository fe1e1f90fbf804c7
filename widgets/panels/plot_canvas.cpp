#include "widgets/panels/plot_canvas.h"

#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include <QBuffer>
#include <QPdfWriter>

#include "widgets/models/plot/plot_texts.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

namespace {

constexpr int print_columns = 4000; ///< points of a line on paper
constexpr int label_px = 16;        ///< room for the names of the cursors above the first canvas

} // namespace

PlotCanvas::PlotCanvas(PlotModel& model, QWidget* parent)
    : QWidget(parent)
    , model_(model)
    , plot_(new QCustomPlot(this)) {
    laidOut(new QVBoxLayout(this), {}, -1, {plot_});
    setFocusProxy(plot_);
    plot_->setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Plot over protocol time"));
    plot_->setAccessibleName(accessibleName());
    setUpPlot();
    matchPanes();
    connectGestures();
    cursorsMoved();
    onThemeChange(this, [this] {
        style(currentTheme());
        plot_->replot(QCustomPlot::rpQueuedReplot);
    });
}

// The panes take themselves out of the plot, which must still be there.
PlotCanvas::~PlotCanvas() {
    plot_->clearItems();
    panes_.clear();
}

void PlotCanvas::setUpPlot() {
    plot_->setAutoAddPlottableToLegend(false);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(0);
    sides_ = new QCPMarginGroup(plot_);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setPlottingHint(QCP::phFastPolylines);
    plot_->setLocale(QLocale::c()); // Decimal points in every locale, like everywhere in the window.
}

void PlotCanvas::matchPanes() {
    const std::size_t wanted = model_.layout().canvases.size();
    if (panes_.size() == wanted)
        return;
    const QCPRange time = panes_.empty() ? QCPRange(0.0, model_.layout().window_s) : panes_[0]->timeAxis()->range();
    plot_->clearItems();
    panes_.clear();
    plot_->plotLayout()->simplify();
    const auto ticker = QSharedPointer<QCPAxisTickerTime>::create();
    for (std::size_t i = 0; i < wanted; ++i) {
        panes_.push_back(std::make_unique<PlotPane>(*plot_, *sides_, static_cast<int>(i)));
        panes_[i]->setTimesShown(i + 1 == wanted);
        QCPAxis* const axis = panes_[i]->timeAxis();
        axis->setTicker(ticker);
        connect(axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &PlotCanvas::showTime);
    }
    for (const auto& [name, text] : {std::pair(Mouse, QString()), {A, tr("A")}, {B, tr("B")}, {Moment, tr("Replay")}})
        marks_[name] = makeMark(text);
    chosen_ = std::min(chosen_, wanted - 1);
    showTime(std::isfinite(time.size()) ? time : QCPRange(0.0, 60.0));
    style(currentTheme());
}

PlotCanvas::Mark PlotCanvas::makeMark(const QString& name) {
    Mark mark;
    const auto place = [](QCPItemPosition* at, const PlotPane& pane, double y) {
        at->setAxes(pane.timeAxis(), pane.valueAxis());
        at->setAxisRect(pane.rect());
        at->setTypeX(QCPItemPosition::ptPlotCoords);
        at->setTypeY(QCPItemPosition::ptAxisRectRatio);
        at->setCoords(0.0, y);
    };
    for (const auto& pane : panes_) {
        auto* line = new QCPItemStraightLine(plot_); // The plot owns it.
        place(line->point1, *pane, 0.0);
        place(line->point2, *pane, 1.0);
        line->setClipAxisRect(pane->rect());
        line->setLayer(QStringLiteral("overlay")); // Moving it draws no curve again.
        line->setSelectable(false);
        mark.lines.push_back(line);
    }
    mark.label = new QCPItemText(plot_);
    place(mark.label->position, *panes_[0], 0.0);
    mark.label->setPositionAlignment(Qt::AlignBottom | Qt::AlignHCenter);
    mark.label->setClipToAxisRect(false);
    mark.label->setLayer(QStringLiteral("overlay"));
    mark.label->setSelectable(false);
    mark.label->setText(name);
    return mark;
}

void PlotCanvas::Mark::show(std::optional<double> time_s, const QCPRange& visible) const {
    const bool seen = time_s && visible.contains(*time_s);
    for (QCPItemStraightLine* line : lines) {
        line->setVisible(seen);
        line->point1->setCoords(time_s.value_or(0.0), 0.0);
        line->point2->setCoords(time_s.value_or(0.0), 1.0);
    }
    label->setVisible(seen && !label->text().isEmpty());
    label->position->setCoords(time_s.value_or(0.0), 0.0);
}

void PlotCanvas::showMarks() {
    const QCPRange visible = panes_[0]->timeAxis()->range();
    const PlotCursors& cursors = model_.cursors();
    marks_[Mouse].show(mouse_px_ ? std::optional(timeAt(*mouse_px_)) : std::nullopt, visible);
    marks_[A].show(cursors.a_s, visible);
    marks_[B].show(cursors.b_s, visible);
    marks_[Moment].show(moment_s_, visible);
}

void PlotCanvas::draw() {
    matchPanes();
    if (!following_ || !fitTime())
        fill();
    style(currentTheme());
    plot_->replot();
}

void PlotCanvas::fill() {
    const std::vector<ShownSeries> all = model_.shown();
    const int columns = std::max(100, static_cast<int>(std::lround(plot_->width() * devicePixelRatioF())));
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        std::vector<ShownSeries> some;
        std::ranges::copy_if(all, std::back_inserter(some), [&](const ShownSeries& each) { return each.canvas == i; });
        panes_[i]->setSeries(std::move(some));
        panes_[i]->setChosen(panes_.size() > 1 && i == chosen_);
        panes_[i]->fill(model_.shownUntil_s(), columns);
    }
    showMarks();
}

void PlotCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fill();
}

void PlotCanvas::showTime(const QCPRange& range) {
    if (taking_time_)
        return;
    taking_time_ = true;
    for (const auto& pane : panes_)
        pane->timeAxis()->setRange(range);
    taking_time_ = false;
    const auto ticker = panes_[0]->timeAxis()->ticker().dynamicCast<QCPAxisTickerTime>();
    ticker->setTimeFormat(range.size() < 5.0 ? QStringLiteral("%m:%s.%z") : QStringLiteral("%h:%m:%s"));
    fill();
    emit readoutChanged();
}

void PlotCanvas::setFollowing(bool following) {
    following_ = following;
    if (!following)
        return;
    fitTime();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

// Until the window is full of samples, the line grows from the left edge.
bool PlotCanvas::fitTime() {
    const std::optional<double> newest = model_.newest_s();
    const std::optional<double> oldest = model_.oldest_s();
    if (!newest || !oldest)
        return false;
    const double window_s = model_.layout().window_s;
    const double span = std::isfinite(window_s) ? window_s : std::max(1.0, *newest - *oldest);
    const double from = std::max(*oldest, *newest - span);
    showTime({from, from + span});
    return true;
}

void PlotCanvas::emphasize(const std::set<SeriesKey>& keys) {
    emphasized_ = keys;
    style(currentTheme());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::setMoment(std::optional<double> time_s) {
    if (moment_s_ == time_s)
        return;
    const bool appears = moment_s_.has_value() != time_s.has_value();
    moment_s_ = time_s;
    showMarks();
    if (appears) { // Its name needs room.
        style(currentTheme());
        return plot_->replot(QCustomPlot::rpQueuedReplot);
    }
    plot_->layer(QStringLiteral("overlay"))->replot();
}

int PlotCanvas::pointCount(const SeriesKey& key) const {
    int count = 0;
    for (const auto& pane : panes_)
        count = std::max(count, pane->pointCount(key));
    return count;
}

void PlotCanvas::style(Theme theme) {
    const Tokens& t = tokens(theme);
    plot_->setBackground(QBrush(t.surface));
    for (const auto& pane : panes_)
        pane->style(theme, emphasized_);
    const bool labels = model_.cursors().a_s || model_.cursors().b_s || moment_s_;
    panes_[0]->rect()->setMinimumMargins({12, labels ? label_px : 6, 12, 6});
    const std::pair<MarkName, QPen> pens[] = {{Mouse, QPen(t.text_muted, 1.0)},
                                              {A, QPen(t.accent, 1.5)},
                                              {B, QPen(t.caution, 1.5)},
                                              {Moment, QPen(t.text, 1.0, Qt::DashLine)}};
    for (const auto& [name, pen] : pens) {
        for (QCPItemStraightLine* line : marks_[name].lines)
            line->setPen(pen);
        marks_[name].label->setColor(pen.color());
        marks_[name].label->setFont(themeFont(FontRole::Small, QFont::DemiBold));
    }
}

void PlotCanvas::compose(const QString& title, Theme theme, const std::function<void()>& render) {
    QCPLayoutGrid* const grid = plot_->plotLayout();
    auto* const head = new QCPTextElement(plot_, title, themeFont(FontRole::Body, QFont::DemiBold));
    head->setTextColor(tokens(theme).text);
    grid->insertRow(0);
    grid->addElement(0, 0, head);
    std::vector<QCPLegend*> legends;
    for (std::size_t i = 0; i < panes_.size(); ++i) {
        panes_[i]->setChosen(false);
        legends.push_back(panes_[i]->addLegend(static_cast<int>(i) + 1, theme));
    }
    grid->setColumnStretchFactor(1, 0.001); // As narrow as the legend's words.
    panes_.back()->timeAxis()->setLabel(tr("Protocol time, h:min:s"));
    style(theme);
    marks_[Mouse].show(std::nullopt, {});
    render();
    panes_.back()->timeAxis()->setLabel({});
    for (QCPLegend* legend : legends)
        grid->remove(legend);
    grid->remove(head);
    grid->simplify();
    draw();
}

QPixmap PlotCanvas::picture(const QString& title) {
    QPixmap picture;
    compose(title, currentTheme(), [&] { picture = plot_->toPixmap(0, 0, 2.0); });
    return picture;
}

QByteArray PlotCanvas::pdf(const QString& title) {
    constexpr int width_px = 1050;
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QPdfWriter writer(&bytes);
    writer.setTitle(title);
    writer.setResolution(600);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageOrientation(QPageLayout::Landscape);
    writer.setPageMargins({12.0, 12.0, 12.0, 12.0}, QPageLayout::Millimeter);
    const double scale = static_cast<double>(writer.width()) / width_px;
    compose(title, Theme::Light, [&] {
        for (const auto& pane : panes_)
            pane->fill(model_.shownUntil_s(), print_columns);
        plot_->setBackground(QBrush(Qt::white));
        QCPPainter painter(&writer);
        painter.setModes(QCPPainter::pmVectorized | QCPPainter::pmNonCosmetic);
        painter.scale(scale, scale);
        plot_->toPainter(&painter, width_px, static_cast<int>(writer.height() / scale));
    });
    return bytes.data();
}

} // namespace usar::widgets
