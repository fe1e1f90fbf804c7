#include "widgets/plan/editor/plan_canvas.h"

#include <algorithm>

#include <QApplication>
#include <QContextMenuEvent>
#include <QDrag>
#include <QDragMoveEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>

#include "widgets/plan/editor/plan_palette.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr const char* node_mime_type = "application/x-usar-plan-node";
constexpr int broad_px = 900;
constexpr double edge_share = 0.3; ///< upper and lower share of a card's height on which a drop means before or after

} // namespace

PlanCanvas::PlanCanvas(QWidget* parent) : PlanView(parent), line_(new QLineEdit(this)) {
    setAcceptDrops(true);
    setAccessibleName(tr("Drawing of the plan, to be edited"));
    line_->hide();
    line_->setAccessibleName(tr("Words of the selected part"));
    line_->setFont(codeFont());
    line_->installEventFilter(this);
    connect(this, &PlanView::treeChanged, this, [this] {
        closeLine(false);
        hover_.reset();
        taken_ = range_end_ = {};
    });
    connect(this, &PlanView::selectionChanged, this, [this] { range_end_ = {}; });
}

/// False for the root, for the collection, and on a fold mark.
bool PlanCanvas::canBeTaken(PlanNodeId node, const QPointF& on_screen) {
    return node.valid() && tree()[node].kind != PlanNodeKind::Plan && tree()[node].kind != PlanNodeKind::Collection &&
           !onFoldMark(node, on_screen);
}

void PlanCanvas::mousePressEvent(QMouseEvent* event) {
    closeLine(true);
    taken_ = {};
    const PlanNodeId node = nodeAt(event->position());
    if (event->button() == Qt::LeftButton && event->modifiers() == Qt::ShiftModifier && selected().valid() &&
        node.valid())
        return extendTo(node);
    if (event->button() == Qt::LeftButton && gestures_ && gestures_() && canBeTaken(node, event->position())) {
        taken_ = node;
        taken_at_ = event->position();
    }
    PlanView::mousePressEvent(event);
}

void PlanCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!taken_.valid() || !(event->buttons() & Qt::LeftButton))
        return PlanView::mouseMoveEvent(event);
    if ((event->position() - taken_at_).manhattanLength() < QApplication::startDragDistance())
        return;
    const PlanNodeId node = std::exchange(taken_, {});
    QMouseEvent release(QEvent::MouseButtonRelease, taken_at_, mapToGlobal(taken_at_), Qt::LeftButton, Qt::NoButton,
                        Qt::NoModifier);
    PlanView::mouseReleaseEvent(&release); // The view sees a click, which selects the node.
    startDrag(node);
}

void PlanCanvas::mouseReleaseEvent(QMouseEvent* event) {
    taken_ = {};
    PlanView::mouseReleaseEvent(event);
}

/// In a narrow canvas there is more room below than at the side.
void PlanCanvas::resizeEvent(QResizeEvent* event) {
    setFlow(width() < broad_px ? PlanFlow::Down : PlanFlow::Across);
    PlanView::resizeEvent(event);
}

/// An open line editor would not move with its card.
void PlanCanvas::wheelEvent(QWheelEvent* event) {
    closeLine(true);
    PlanView::wheelEvent(event);
}

void PlanCanvas::startDrag(PlanNodeId node) {
    auto* mime = new QMimeData;
    mime->setData(QString::fromLatin1(node_mime_type), QByteArray::number(node.value));
    mime->setText(tree()[node].name);
    QDrag drag(this);
    drag.setMimeData(mime);
    drag.exec(Qt::MoveAction | Qt::CopyAction, Qt::MoveAction);
    hover_.reset();
    update();
}

void PlanCanvas::contextMenuEvent(QContextMenuEvent* event) {
    const bool by_key = event->reason() == QContextMenuEvent::Keyboard;
    const PlanNodeId node = by_key ? selected() : nodeAt(event->pos());
    if (!by_key && node.valid())
        select(node);
    QPoint at = event->globalPos();
    if (by_key && node.valid())
        at = mapToGlobal(toScreen(layout().box(tree(), node).bottomLeft()).toPoint());
    emit menuRequested(node, at);
}

std::optional<std::variant<PlanPiece, PlanNodeId>> PlanCanvas::sourceOf(const QMimeData& mime) const {
    if (const auto piece = pieceOf(mime))
        return *piece;
    bool good = false;
    const PlanNodeId node{mime.data(QString::fromLatin1(node_mime_type)).toInt(&good)};
    if (!good || !tree().contains(node))
        return std::nullopt;
    return node;
}

PlanCanvas::Hover PlanCanvas::hoverAt(const std::variant<PlanPiece, PlanNodeId>& source, const QPointF& on_screen) {
    Hover hover{.node = nodeAt(on_screen), .at = on_screen};
    if (hover.node.valid()) {
        const QRectF box = layout().box(tree(), hover.node);
        const double share = (toLayout(on_screen).y() - box.top()) / std::max(1.0, box.height());
        hover.zone = share < edge_share         ? DropZone::Before
                     : share > 1.0 - edge_share ? DropZone::After
                                                : DropZone::Onto;
    }
    if (const PlanGestures* const gestures = gestures_ ? gestures_() : nullptr)
        hover.deed = gestures->drop(source, hover.node, hover.zone);
    return hover;
}

void PlanCanvas::dragEnterEvent(QDragEnterEvent* event) {
    if (sourceOf(*event->mimeData()))
        event->acceptProposedAction();
}

void PlanCanvas::dragMoveEvent(QDragMoveEvent* event) {
    const auto source = sourceOf(*event->mimeData());
    if (!source)
        return event->ignore();
    hover_ = hoverAt(*source, event->position());
    event->setAccepted(hover_->deed.has_value());
    update();
}

void PlanCanvas::dragLeaveEvent(QDragLeaveEvent*) {
    hover_.reset();
    update();
}

void PlanCanvas::dropEvent(QDropEvent* event) {
    const auto source = sourceOf(*event->mimeData());
    hover_.reset();
    update();
    if (!source)
        return event->ignore();
    const Hover hover = hoverAt(*source, event->position());
    event->accept();
    setFocus(Qt::MouseFocusReason);
    if (hover.deed)
        emit deedRequested(*hover.deed);
    else
        emit dropRefused();
}

/// A range consists of siblings: the steps of a pattern, or the members of a form.
void PlanCanvas::extendTo(PlanNodeId node) {
    const PlanNodeId from = tree().cardOf(selected());
    const PlanNodeId to = tree().cardOf(node);
    if (tree()[from].parent != tree()[to].parent)
        return;
    range_end_ = to == from ? PlanNodeId{} : to;
    update();
    emit rangeChanged();
}

std::vector<PlanNodeId> PlanCanvas::range() const {
    if (!selected().valid() || !range_end_.valid())
        return selected().valid() ? std::vector<PlanNodeId>{selected()} : std::vector<PlanNodeId>();
    const auto [first, last] = std::minmax({tree().cardOf(selected()), range_end_});
    std::vector<PlanNodeId> nodes;
    for (const PlanNodeId card : tree().children(tree()[first].parent))
        if (card >= first && card <= last)
            nodes.push_back(card);
    return nodes;
}

void PlanCanvas::keyPressEvent(QKeyEvent* event) {
    const bool extends = event->modifiers() == Qt::ShiftModifier && selected().valid() &&
                         (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down);
    if (!extends)
        return PlanView::keyPressEvent(event);
    const PlanNodeId end = range_end_.valid() ? range_end_ : tree().cardOf(selected());
    if (!tree()[end].parent.valid())
        return;
    const auto cards = tree().children(tree()[end].parent);
    const auto here =
        std::find(cards.begin(), cards.end(), end) - cards.begin() + (event->key() == Qt::Key_Up ? -1 : 1);
    if (here >= 0 && here < std::ssize(cards))
        extendTo(cards[static_cast<std::size_t>(here)]);
}

QRectF PlanCanvas::frameOf(PlanNodeId node) {
    const QRectF box = layout().box(tree(), node);
    return QRectF(toScreen(box.topLeft()), toScreen(box.bottomRight())).adjusted(-3, -3, 3, 3);
}

/// Paints the range over the drawing and, during a drag, the place of the drop and a note about its effect.
void PlanCanvas::paintEvent(QPaintEvent* event) {
    PlanView::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens().accent, 2.0, Qt::DashLine));
    if (range_end_.valid())
        for (const PlanNodeId node : range())
            painter.drawRoundedRect(frameOf(node), 8, 8);
    if (!hover_)
        return;
    if (hover_->node.valid() && hover_->deed) {
        const QRectF frame = frameOf(hover_->node);
        painter.setPen(QPen(tokens().accent, 3.0));
        if (hover_->zone == DropZone::Onto)
            painter.drawRoundedRect(frame, 8, 8);
        else if (hover_->zone == DropZone::Before)
            painter.drawLine(frame.topLeft() + QPointF(3, 0), frame.topRight() - QPointF(3, 0));
        else
            painter.drawLine(frame.bottomLeft() + QPointF(3, 0), frame.bottomRight() - QPointF(3, 0));
    }
    const QString words = hover_->deed ? hover_->deed->words : tr("It cannot be dropped here");
    QRectF note = QFontMetricsF(font()).boundingRect(words).adjusted(-gap::small, -gap::tiny, gap::small, gap::tiny);
    note.moveTopLeft(hover_->at + QPointF(16, 16));
    note.moveLeft(std::clamp(note.left(), 0.0, std::max(0.0, width() - note.width())));
    note.moveTop(std::min(note.top(), height() - note.height()));
    painter.setPen(QPen(hover_->deed ? tokens().accent : tokens().line, 1.0));
    painter.setBrush(tokens().raised);
    painter.drawRoundedRect(note, 4, 4);
    painter.setPen(hover_->deed ? tokens().text : tokens().text_muted);
    painter.drawText(note, Qt::AlignCenter, words);
}

void PlanCanvas::editInPlace(PlanNodeId node, const QString& words, int what) {
    if (!node.valid())
        return;
    select(node);
    const QRectF box = layout().box(tree(), node);
    const QPointF corner = toScreen(box.topLeft());
    const int wanted = std::max(
        {200, static_cast<int>(box.width() * scale()), QFontMetrics(line_->font()).horizontalAdvance(words) + 40});
    const int wide = std::min(wanted, width() - 2 * gap::small);
    const int left =
        std::clamp(static_cast<int>(corner.x()), gap::small, std::max(gap::small, width() - wide - gap::small));
    line_node_ = node;
    line_what_ = what;
    line_->setText(words);
    line_->setGeometry(left, std::clamp(static_cast<int>(corner.y()), 0, std::max(0, height() - 28)), wide, 28);
    line_->show();
    line_->selectAll();
    line_->setFocus(Qt::OtherFocusReason);
}

/// Does nothing when called again: hiding the line moves the focus, which closes the line once more.
void PlanCanvas::closeLine(bool keep) {
    if (!line_node_.valid())
        return;
    const PlanNodeId node = std::exchange(line_node_, {});
    const bool changed = line_->isModified();
    const bool had_focus = line_->hasFocus();
    line_->hide();
    if (had_focus)
        setFocus(Qt::OtherFocusReason);
    if (keep && changed)
        emit wordsEntered(node, line_->text(), line_what_);
}

bool PlanCanvas::eventFilter(QObject* watched, QEvent* event) {
    if (watched == line_ && event->type() == QEvent::FocusOut &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason)
        closeLine(true);
    if (watched != line_ || (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride))
        return PlanView::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool is_return = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    const bool is_escape = key.key() == Qt::Key_Escape;
    const bool means_the_drawing = key.key() == Qt::Key_Up || key.key() == Qt::Key_Down ||
                                   (key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35) ||
                                   key.modifiers() == Qt::AltModifier;
    if (!is_return && !is_escape && !means_the_drawing)
        return false;
    event->accept(); // It must not reach the drawing below.
    if (event->type() == QEvent::KeyPress && !means_the_drawing)
        closeLine(is_return);
    return true;
}

} // namespace usar::widgets
