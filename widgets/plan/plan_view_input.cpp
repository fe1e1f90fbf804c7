#include <array>

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "widgets/models/plan/plan_selection.h"
#include "widgets/plan/plan_view.h"

namespace usar::widgets {

namespace {

/// Returns the step that Ctrl with an arrow key makes; nullopt for other keys.
std::optional<PlanStep> stepOf(const QKeyEvent& event) {
    constexpr std::array steps{PlanStep::Out, PlanStep::Before, PlanStep::In, PlanStep::After}; // Left, Up, Right, Down
    const int arrow = event.key() - Qt::Key_Left;
    if (!(event.modifiers() & Qt::ControlModifier) || arrow < 0 || arrow >= std::ssize(steps))
        return std::nullopt;
    return steps[static_cast<std::size_t>(arrow)];
}

/// Returns by how much a key moves the drawing in a view of this size, in pixels; nullopt for keys that do not pan.
std::optional<QPointF> panOf(const QKeyEvent& event, const QSizeF& view) {
    const int key = event.key();
    const bool by_page = key == Qt::Key_PageUp || key == Qt::Key_PageDown || event.modifiers() & Qt::ShiftModifier;
    const QSizeF step = by_page ? 0.8 * view : QSizeF(64.0, 64.0);
    const int right = key == Qt::Key_Left ? 1 : key == Qt::Key_Right ? -1 : 0;
    const int down = key == Qt::Key_Up || key == Qt::Key_PageUp       ? 1
                     : key == Qt::Key_Down || key == Qt::Key_PageDown ? -1
                                                                      : 0;
    if (right == 0 && down == 0)
        return std::nullopt;
    return QPointF(right * step.width(), down * step.height());
}

} // namespace

void PlanView::resizeEvent(QResizeEvent* event) {
    const bool other_flow = drawing_.turn();
    if (framing_ == Framing::Whole)
        fit();
    else if (other_flow || framing_ == Framing::Beginning)
        showBeginning();
    QWidget::resizeEvent(event);
}

void PlanView::showEvent(QShowEvent* event) {
    takeNews();
    QWidget::showEvent(event);
}

void PlanView::mousePressEvent(QMouseEvent* event) {
    pressed_at_ = last_at_ = event->position();
    gesture_ = event->button() == Qt::LeftButton     ? Gesture::Pressed
               : event->button() == Qt::MiddleButton ? Gesture::Panning
                                                     : Gesture::None;
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (gesture_ == Gesture::Pressed && (at - pressed_at_).manhattanLength() >= QApplication::startDragDistance())
        gesture_ = Gesture::Panning;
    if (gesture_ == Gesture::Panning) {
        setCursor(Qt::ClosedHandCursor);
        panBy(at - last_at_);
    } else if (const PlanNodeId node = nodeAt(at); node != hot_) {
        hot_ = node;
        update();
    }
    if (gesture_ != Gesture::Panning)
        setCursor(hot_.valid() && onFoldMark(hot_, at) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    last_at_ = at;
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = std::exchange(gesture_, Gesture::None) == Gesture::Pressed;
    setCursor(Qt::ArrowCursor);
    if (!clicked)
        return;
    const PlanNodeId node = nodeAt(event->position());
    if (node.valid() && onFoldMark(node, event->position()))
        open(node);
    else
        select(node);
}

void PlanView::mouseDoubleClickEvent(QMouseEvent* event) {
    // No gesture begins, so that the second release does not count as a click.
    const PlanNodeId node = nodeAt(event->position());
    if (event->button() != Qt::LeftButton || !node.valid())
        return;
    if (onFoldMark(node, event->position()))
        open(node);
    else if (tree()[node].link.valid())
        select(tree()[node].link);
    else
        emit activated(node);
}

void PlanView::open(PlanNodeId node) {
    if (tree()[node].link.valid())
        select(tree()[node].link);
    else
        setFolded(node, !folds().folded(tree(), node));
}

void PlanView::wheelEvent(QWheelEvent* event) {
    if (const int delta = event->angleDelta().y(); delta != 0 && !tree().empty())
        zoomAt(event->position(), zoom_step::ofWheel(delta));
    event->accept();
}

void PlanView::keyPressEvent(QKeyEvent* event) {
    if (tree().empty())
        return QWidget::keyPressEvent(event);
    if (const auto step = stepOf(*event)) {
        if (const PlanNodeId node = planStep(tree(), selected(), *step); node.valid())
            select(node);
    } else if (const auto by_px = panOf(*event, size())) {
        panBy(*by_px);
    } else if (!actByKey(*event)) {
        QWidget::keyPressEvent(event);
    }
}

bool PlanView::actByKey(const QKeyEvent& event) {
    if (event.modifiers() & Qt::ControlModifier)
        return false;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomIn(), true;
    case Qt::Key_Minus:
        return zoomOut(), true;
    case Qt::Key_F:
        return fit(), true;
    case Qt::Key_Home:
        return select(PlanNodeId{0}), true;
    case Qt::Key_End:
        return select(PlanNodeId{tree().size() - 1}), true;
    case Qt::Key_N:
        if (const PlanNodeId node = nextOf(states_.running(tree()), selected(), event.modifiers() & Qt::ShiftModifier);
            node.valid())
            select(node);
        return true;
    case Qt::Key_Space:
        if (selected().valid())
            open(tree().cardOf(selected()));
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (selected().valid() && tree()[selected()].link.valid())
            select(tree()[selected()].link);
        else if (selected().valid())
            emit activated(selected());
        return true;
    case Qt::Key_Escape:
        return selected().valid() ? (select({}), true) : false;
    default:
        return false;
    }
}

void PlanView::leaveEvent(QEvent*) {
    hot_ = {};
    update();
}

void PlanView::contextMenuEvent(QContextMenuEvent* event) {
    if (tree().empty())
        return;
    if (event->reason() == QContextMenuEvent::Mouse)
        select(nodeAt(event->pos()));
    QPoint at = event->globalPos();
    if (event->reason() == QContextMenuEvent::Keyboard && selected().valid())
        at = mapToGlobal(toScreen(layout().box(tree(), selected()).center()).toPoint());
    emit menuRequested(selected(), at);
}

bool PlanView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        const PlanNodeId node = tree().empty() ? PlanNodeId{} : nodeAt(help->pos());
        QToolTip::showText(help->globalPos(), node.valid() ? nodeText(node) : QString(), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace usar::widgets
