#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "widgets/plan/plan_painter.h"
#include "widgets/plan/plan_view.h"

namespace usar::widgets {

void PlanView::resizeEvent(QResizeEvent* event) {
    const bool other_flow = layout_valid_ && wantedFlow() != layout_.flow();
    if (other_flow)
        layout_valid_ = false;
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

int PlanView::nodeAt(const QPointF& on_screen) {
    const int node = layout().nodeAt(tree_, toLayout(on_screen));
    if (node < 0 || !tree_[node].in_card || planDetailAt(scale_) == PlanDetail::Full)
        return node;
    return tree_[node].parent; // Its row is not drawn at this scale.
}

bool PlanView::onFoldMark(int node, const QPointF& on_screen) {
    if (tree_[node].in_card || (tree_.children(node).empty() && tree_[node].link < 0) ||
        planDetailAt(scale_) != PlanDetail::Full)
        return false;
    const QRectF box = layout().box(tree_, node);
    const QRectF mark(box.right() - plan_card::fold_px, box.top(), plan_card::fold_px, row_px_ + plan_card::padding_px);
    return mark.contains(toLayout(on_screen));
}

void PlanView::mousePressEvent(QMouseEvent* event) {
    pressed_at_ = last_at_ = event->position();
    pressed_ = event->button() == Qt::LeftButton;
    panning_ = event->button() == Qt::MiddleButton;
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (pressed_ && (at - pressed_at_).manhattanLength() >= QApplication::startDragDistance()) {
        pressed_ = false;
        panning_ = true;
    }
    if (panning_) {
        setCursor(Qt::ClosedHandCursor);
        panBy(at - last_at_);
    } else if (const int node = nodeAt(at); node != hot_) {
        hot_ = node;
        update();
    }
    if (!panning_)
        setCursor(hot_ >= 0 && onFoldMark(hot_, at) ? Qt::PointingHandCursor : Qt::ArrowCursor);
    last_at_ = at;
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = std::exchange(pressed_, false);
    panning_ = false;
    setCursor(Qt::ArrowCursor);
    if (!clicked)
        return;
    const int node = nodeAt(event->position());
    if (node >= 0 && onFoldMark(node, event->position()))
        open(node);
    else
        select(node);
}

void PlanView::mouseDoubleClickEvent(QMouseEvent* event) {
    // No gesture begins, so that the second release does not count as a click.
    const int node = nodeAt(event->position());
    if (event->button() != Qt::LeftButton || node < 0)
        return;
    if (onFoldMark(node, event->position()))
        open(node);
    else if (tree_[node].link >= 0)
        select(tree_[node].link);
    else
        emit activated(node);
}

/// Follows a link, or folds or unfolds the node.
void PlanView::open(int node) {
    if (tree_[node].link >= 0)
        select(tree_[node].link);
    else
        setFolded(node, !folds_.folded(tree_, node));
}

void PlanView::wheelEvent(QWheelEvent* event) {
    if (const double notches = event->angleDelta().y() / 120.0; notches != 0.0 && !tree_.empty())
        zoomAt(event->position(), std::pow(1.2, notches));
    event->accept();
}

void PlanView::keyPressEvent(QKeyEvent* event) {
    if (!tree_.empty() && (walkByKey(*event) || panByKey(*event) || actByKey(*event)))
        return;
    QWidget::keyPressEvent(event);
}

bool PlanView::panByKey(const QKeyEvent& event) {
    const bool page = event.modifiers() & Qt::ShiftModifier;
    const QPointF step = page ? QPointF(0.8 * width(), 0.8 * height()) : QPointF(64.0, 64.0);
    switch (event.key()) {
    case Qt::Key_Left:
        return panBy({step.x(), 0.0}), true;
    case Qt::Key_Right:
        return panBy({-step.x(), 0.0}), true;
    case Qt::Key_Up:
        return panBy({0.0, step.y()}), true;
    case Qt::Key_Down:
        return panBy({0.0, -step.y()}), true;
    case Qt::Key_PageUp:
        return panBy({0.0, 0.8 * height()}), true;
    case Qt::Key_PageDown:
        return panBy({0.0, -0.8 * height()}), true;
    default:
        return false;
    }
}

bool PlanView::walkByKey(const QKeyEvent& event) {
    if (!(event.modifiers() & Qt::ControlModifier) || event.key() < Qt::Key_Left || event.key() > Qt::Key_Down)
        return false;
    if (const int node = neighbor(event.key()); node >= 0)
        select(node);
    return true;
}

/// Returns the node that a step from the selection leads to; the root if nothing is selected, -1 at an end.
int PlanView::neighbor(int key) const {
    if (selected_ < 0)
        return 0;
    if (key == Qt::Key_Left)
        return tree_[selected_].parent;
    if (key == Qt::Key_Right) {
        const auto children = tree_.children(selected_);
        return children.empty() ? tree_[selected_].link : children.front();
    }
    return sibling(selected_, key == Qt::Key_Up ? -1 : 1);
}

/// Steps down from a card to its senses, and from the last of them to the next card; and in reverse.
int PlanView::sibling(int node, int by) const {
    const PlanNode& what = tree_[node];
    if (by > 0 && what.senses > 0)
        return node + 1;
    if (what.in_card && (by < 0 || node + by <= what.parent + tree_[what.parent].senses))
        return node + by;
    const int card = what.in_card ? what.parent : node;
    if (tree_[card].parent < 0)
        return -1;
    const auto cards = tree_.children(tree_[card].parent);
    const auto here = std::find(cards.begin(), cards.end(), card) - cards.begin() + by;
    if (here < 0 || here >= std::ssize(cards))
        return -1;
    const int next = cards[static_cast<std::size_t>(here)];
    return by < 0 ? next + tree_[next].senses : next;
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
        return select(0), true;
    case Qt::Key_End:
        return select(tree_.size() - 1), true;
    case Qt::Key_N:
        return walkRunning(event.modifiers() & Qt::ShiftModifier ? -1 : 1), true;
    case Qt::Key_Space:
        if (selected_ >= 0)
            open(tree_[selected_].in_card ? tree_[selected_].parent : selected_);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (selected_ >= 0 && tree_[selected_].link >= 0)
            select(tree_[selected_].link);
        else if (selected_ >= 0)
            emit activated(selected_);
        return true;
    case Qt::Key_Escape:
        return selected_ >= 0 ? (select(-1), true) : false;
    default:
        return false;
    }
}

void PlanView::walkRunning(int by) {
    const std::vector<int> running = states_.running(tree_);
    if (running.empty())
        return;
    const auto after = std::upper_bound(running.begin(), running.end(), selected_);
    const auto here = std::lower_bound(running.begin(), running.end(), selected_);
    if (by > 0)
        select(after == running.end() ? running.front() : *after);
    else
        select(here == running.begin() ? running.back() : *(here - 1));
}

void PlanView::leaveEvent(QEvent*) {
    hot_ = -1;
    update();
}

void PlanView::contextMenuEvent(QContextMenuEvent* event) {
    if (tree_.empty())
        return;
    if (event->reason() == QContextMenuEvent::Mouse)
        select(nodeAt(event->pos()));
    QPoint at = event->globalPos();
    if (event->reason() == QContextMenuEvent::Keyboard && selected_ >= 0)
        at = mapToGlobal(toScreen(layout().box(tree_, selected_).center()).toPoint());
    emit menuRequested(selected_, at);
}

void PlanView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) {
        sizes_.clear();
        layout_valid_ = false;
        update();
    }
    QWidget::changeEvent(event);
}

bool PlanView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        const int node = tree_.empty() ? -1 : nodeAt(help->pos());
        QToolTip::showText(help->globalPos(), node < 0 ? QString() : nodeText(node), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace usar::widgets
