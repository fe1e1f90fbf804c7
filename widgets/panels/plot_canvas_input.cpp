// Gestures and keys of the plots: zooming, panning, cursors.
#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

#include <QApplication>

#include "widgets/models/plot/plot_texts.h"
#include "widgets/panels/plot_canvas.h"

namespace usar::widgets {

namespace {

constexpr double reach_px = 5.0; ///< the mouse takes hold of a cursor at this distance

} // namespace

void PlotCanvas::connectGestures() {
    plot_->installEventFilter(this);
    connect(plot_, &QCustomPlot::mouseWheel, this, [this](QWheelEvent* event) {
        if (!panes_[canvasAt(event->position().toPoint())]->aimWheel(event->position()))
            leaveFollowing();
    });
    // These are called before QCustomPlot handles the event itself.
    connect(plot_, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) { press(*event); });
    connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) { move(*event); });
    connect(plot_, &QCustomPlot::mouseRelease, this, [this](const QMouseEvent* event) { release(*event); });
    connect(plot_, &QCustomPlot::mouseDoubleClick, this, &PlotCanvas::followAgain);
}

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Leave) {
        mouse_px_.reset();
        showMarks();
        plot_->layer(QStringLiteral("overlay"))->replot();
        emit readoutChanged();
    }
    return QWidget::eventFilter(watched, event);
}

void PlotCanvas::press(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton)
        return;
    choose(canvasAt(event.position().toPoint()));
    pressed_px_ = event.position();
    const double x_px = event.position().x();
    dragged_ = model_.cursors().near(timeAt(x_px), timeAt(x_px + reach_px) - timeAt(x_px));
    setPanning(!dragged_);
}

void PlotCanvas::move(const QMouseEvent& event) {
    const QPointF at_px = event.position();
    const QRect span = panes_[0]->rect()->rect();
    mouse_px_ = span.left() <= at_px.x() && at_px.x() <= span.right() ? std::optional(at_px.x()) : std::nullopt;
    const bool far = pressed_px_ && (at_px - *pressed_px_).manhattanLength() >= QApplication::startDragDistance();
    if (event.buttons() & Qt::LeftButton && far) {
        before_click_ = model_.cursors();
        if (dragged_) {
            model_.cursors().place(*dragged_, timeAt(at_px.x()));
            cursorsMoved();
        } else {
            leaveFollowing();
        }
    }
    const double x_px = at_px.x();
    const bool hold = dragged_ || model_.cursors().near(timeAt(x_px), timeAt(x_px + reach_px) - timeAt(x_px));
    plot_->setCursor(hold ? Qt::SplitHCursor : Qt::ArrowCursor);
    showMarks();
    plot_->layer(QStringLiteral("overlay"))->replot();
    emit readoutChanged();
}

void PlotCanvas::release(const QMouseEvent& event) {
    const bool click = event.button() == Qt::LeftButton && pressed_px_ &&
                       (event.position() - *pressed_px_).manhattanLength() < QApplication::startDragDistance();
    pressed_px_.reset();
    const std::optional<CursorName> held = std::exchange(dragged_, std::nullopt);
    setPanning(true);
    if (!click)
        return;
    before_click_ = model_.cursors();
    const double time_s = timeAt(event.position().x());
    if (onTimeAxis(event.position()) || event.modifiers() & Qt::ControlModifier) {
        if (moment_s_)
            emit momentRequested(Seconds(time_s));
        return;
    }
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    if (held && !shift)
        model_.cursors().active = held;
    else
        model_.cursors().place(shift ? CursorName::B : CursorName::A, time_s);
    cursorsMoved();
}

// The first of the two clicks has placed a cursor.
void PlotCanvas::followAgain() {
    model_.cursors() = before_click_;
    pressed_px_.reset();
    cursorsMoved();
    for (const auto& pane : panes_)
        pane->letValuesFit();
    setFollowing(true);
    emit followingChanged(true);
    plot_->replot();
}

void PlotCanvas::setPanning(bool on) {
    for (const auto& pane : panes_)
        pane->rect()->setRangeDrag(on ? Qt::Orientations(Qt::Horizontal) : Qt::Orientations());
}

void PlotCanvas::leaveFollowing() {
    if (!following_)
        return;
    following_ = false;
    emit followingChanged(false);
}

void PlotCanvas::cursorsMoved() {
    const QString help =
        tr("Values over protocol time, hours:minutes:seconds. Drag or use the arrow keys to move in time, the wheel or "
           "plus and minus to zoom, Space to pause, F to follow. Click or A places cursor A, Shift and click or B "
           "places cursor B; then the arrow keys move that cursor, and Delete removes it.");
    const QString values = cursorSentences(model_);
    setAccessibleDescription(values.isEmpty() ? help : values + u' ' + help);
    plot_->setAccessibleDescription(accessibleDescription());
    style(currentTheme());
    showMarks();
    plot_->replot(QCustomPlot::rpQueuedReplot);
    emit cursorsChanged();
}

void PlotCanvas::placeCursor(CursorName name) {
    const double middle_s = panes_[0]->timeAxis()->range().center();
    model_.cursors().place(name, mouse_px_ ? timeAt(*mouse_px_) : middle_s);
    cursorsMoved();
}

bool PlotCanvas::moveCursor(double by_px) {
    if (!model_.cursors().move(timeAt(by_px) - timeAt(0.0)))
        return false;
    cursorsMoved();
    return true;
}

bool PlotCanvas::removeCursor() {
    if (!model_.cursors().remove())
        return false;
    cursorsMoved();
    return true;
}

void PlotCanvas::zoomTime(double factor) {
    leaveFollowing();
    panes_[0]->timeAxis()->scaleRange(1.0 / factor);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::panTime(double fraction) {
    leaveFollowing();
    panes_[0]->timeAxis()->moveRange(fraction * panes_[0]->timeAxis()->range().size());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::choose(std::size_t canvas) {
    if (canvas >= panes_.size() || canvas == chosen_)
        return;
    chosen_ = canvas;
    for (std::size_t i = 0; i < panes_.size(); ++i)
        panes_[i]->setChosen(i == chosen_);
    style(currentTheme());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

std::size_t PlotCanvas::canvasAt(const QPoint& at) const {
    for (std::size_t i = 0; i + 1 < panes_.size(); ++i)
        if (at.y() <= panes_[i]->rect()->bottom())
            return i;
    return panes_.size() - 1;
}

bool PlotCanvas::onTimeAxis(const QPointF& at_px) const {
    return at_px.y() > panes_.back()->rect()->bottom();
}

double PlotCanvas::timeAt(double x_px) const {
    return panes_[0]->timeAxis()->pixelToCoord(x_px);
}

double PlotCanvas::pixelOf(double time_s) const {
    return panes_[0]->timeAxis()->coordToPixel(time_s);
}

Seconds PlotCanvas::visibleFrom() const {
    return Seconds(panes_[0]->timeAxis()->range().lower);
}

Seconds PlotCanvas::visibleTo() const {
    return Seconds(panes_[0]->timeAxis()->range().upper);
}

std::optional<Seconds> PlotCanvas::mouseTime() const {
    return mouse_px_ ? std::optional(Seconds(timeAt(*mouse_px_))) : std::nullopt;
}

} // namespace usar::widgets
