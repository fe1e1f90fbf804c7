#include "widgets/plan/plan_view.h"

#include <algorithm>
#include <cmath>

#include <QPaintEvent>
#include <QPainter>

#include "widgets/models/plan/plan_reasons.h"
#include "widgets/plan/plan_painter.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

namespace {
constexpr double margin_px = 16.0;
constexpr double smallest_scale = 0.01;
constexpr double largest_scale = 4.0;
constexpr double readable_scale = 0.8;
constexpr int broad_node_px = 560; ///< narrower views show an outline
constexpr int tick_ms = 16;
} // namespace

PlanView::PlanView(QWidget* parent) : QWidget(parent), empty_state_(new EmptyState(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Plan"));
    empty_state_->setText(tr("No plan"), tr("The plan of a robot appears here. Choose a behavior that is a plan, then "
                                            "start it."));
    tick_.setSingleShot(true);
    tick_.setInterval(tick_ms);
    tick_.setTimerType(Qt::PreciseTimer);
    connect(&tick_, &QTimer::timeout, this, &PlanView::takeNews);
    describe();
}

PlanView::~PlanView() = default;

void PlanView::setPlan(const posh::Plan& plan) {
    plan_ = plan;
    snapshot_ = {};
    news_ = false;
    const bool was_empty = tree_.empty();
    rebuild();
    if (was_empty || framing_ == Framing::Beginning)
        showBeginning();
}

void PlanView::clear() {
    plan_ = {};
    snapshot_ = {};
    folds_.unfoldAll();
    framing_ = Framing::Beginning;
    rebuild();
}

void PlanView::setSharing(PlanSharing sharing) {
    if (sharing == sharing_)
        return;
    sharing_ = sharing;
    rebuild();
}

/// Selects the same part again, found by its names; if that part is now drawn elsewhere, by its path.
void PlanView::rebuild() {
    const bool had = selected_ >= 0;
    const std::uint64_t key = had ? tree_[selected_].key : 0;
    const std::string path = had ? tree_.path(selected_) : std::string();
    tree_ = PlanTree(plan_, sharing_);
    states_.reset(tree_);
    marks_ = PlanMarks(tree_, marks_by_path_);
    sizes_.clear();
    layout_valid_ = false;
    found_.clear();
    found_marks_.clear();
    hot_ = -1;
    const int same = had ? tree_.findKey(key) : -1;
    selected_ = same >= 0 || !had ? same : tree_.find(path);
    empty_state_->setVisible(tree_.empty());
    news_ = snapshot_.paths != nullptr;
    emit treeChanged();
    emit selectionChanged(selected_);
    if (news_ && isVisible())
        takeNews();
    describe();
    update();
}

void PlanView::setSnapshot(PlanSnapshot snapshot) {
    snapshot_ = std::move(snapshot);
    news_ = true;
    if (isVisible() && !tick_.isActive())
        tick_.start();
}

void PlanView::setMarks(std::vector<PlanMark> marks) {
    if (marks == marks_by_path_)
        return;
    marks_by_path_ = std::move(marks);
    marks_ = PlanMarks(tree_, marks_by_path_);
    describe();
    update();
}

void PlanView::takeNews() {
    if (!news_ || !isVisible())
        return;
    news_ = false;
    ++news_taken_;
    states_.take(tree_, snapshot_);
    describe();
    emit refreshed();
    update();
}

void PlanView::setFlow(std::optional<PlanFlow> flow) {
    flow_ = flow;
    if (layout_valid_ && wantedFlow() != layout_.flow()) {
        layout_valid_ = false;
        showBeginning();
    }
}

PlanFlow PlanView::wantedFlow() const {
    return flow_.value_or(width() < broad_node_px ? PlanFlow::Down : PlanFlow::Across);
}

const PlanLayout& PlanView::layout() {
    if (!layout_valid_)
        relayout();
    return layout_;
}

void PlanView::relayout() {
    if (sizes_.size() != static_cast<std::size_t>(tree_.size())) {
        const PlanMetrics metrics = planMetrics();
        row_px_ = metrics.row_px;
        sizes_ = measurePlan(tree_, metrics);
    }
    layout_ = PlanLayout(tree_, folds_, sizes_, row_px_, wantedFlow());
    layout_valid_ = true;
}

void PlanView::relayoutAround(int node) {
    const QPointF before = node >= 0 ? layout().box(tree_, node).topLeft() : QPointF();
    relayout();
    if (node >= 0 && !layout_.box(tree_, node).isNull())
        corner_ += layout_.box(tree_, node).topLeft() - before;
    keepInReach();
    update();
}

void PlanView::setFolded(int node, bool folded) {
    folds_.set(tree_, node, folded);
    relayoutAround(node);
    if (selected_ >= 0 && layout_.box(tree_, selected_).isNull())
        select(node);
    describe();
}

void PlanView::foldAll() {
    folds_.foldAll(tree_);
    relayout();
    showBeginning();
    if (selected_ >= 0 && layout_.box(tree_, selected_).isNull())
        select(-1);
}

void PlanView::unfoldAll() {
    folds_.unfoldAll();
    relayoutAround(selected_);
}

void PlanView::showRunning() {
    const std::vector<int> running = states_.running(tree_);
    folds_.showOnly(tree_, running);
    relayout();
    if (selected_ >= 0 && layout_.box(tree_, selected_).isNull())
        select(-1);
    showBeginning();
    if (!running.empty())
        bringIntoView(running.back());
}

void PlanView::select(int node) {
    if (node >= 0 && folds_.reveal(tree_, node))
        relayoutAround(selected_);
    if (node >= 0)
        bringIntoView(node);
    if (node != selected_) {
        selected_ = node;
        emit selectionChanged(node);
    }
    describe();
    update();
}

bool PlanView::selectPath(const std::string& path) {
    const int node = tree_.find(path);
    if (node >= 0)
        select(node);
    return node >= 0;
}

int PlanView::find(const QString& words) {
    found_ = tree_.search(words);
    found_marks_.assign(found_.empty() ? 0 : static_cast<std::size_t>(tree_.size()), false);
    for (const int node : found_)
        found_marks_[static_cast<std::size_t>(node)] = true;
    if (!found_.empty() && !std::binary_search(found_.begin(), found_.end(), selected_))
        findNext();
    update();
    return static_cast<int>(found_.size());
}

void PlanView::findNext(bool backward) {
    if (found_.empty())
        return;
    const auto after = std::upper_bound(found_.begin(), found_.end(), selected_);
    if (!backward)
        return select(after == found_.end() ? found_.front() : *after);
    const auto here = std::lower_bound(found_.begin(), found_.end(), selected_);
    select(here == found_.begin() ? found_.back() : *(here - 1));
}

void PlanView::fit() {
    const QRectF all = layout().bounds();
    if (all.isEmpty())
        return;
    const double across = (width() - 2.0 * margin_px) / all.width();
    const double down = (height() - 2.0 * margin_px) / all.height();
    scale_ = std::clamp(std::min(across, down), smallest_scale, 1.0);
    corner_ = all.center() - QPointF(width(), height()) / (2.0 * scale_);
    framing_ = Framing::Whole;
    update();
}

void PlanView::showBeginning() {
    fit();
    framing_ = Framing::Beginning;
    if (scale_ < readable_scale && !layout().bounds().isEmpty()) {
        const double across = (width() - 2.0 * margin_px) / layout_.bounds().width();
        scale_ = std::clamp(across, readable_scale, 1.0);
        corner_ = layout_.bounds().topLeft() - QPointF(margin_px, margin_px) / scale_;
    }
    update();
}

void PlanView::zoomAt(const QPointF& on_screen, double factor) {
    const QPointF held = toLayout(on_screen);
    scale_ = std::clamp(scale_ * factor, smallest_scale, largest_scale);
    corner_ = held - on_screen / scale_;
    framing_ = Framing::Own;
    keepInReach();
    update();
}

void PlanView::zoomIn() {
    zoomAt(QRectF(rect()).center(), 1.25);
}

void PlanView::zoomOut() {
    zoomAt(QRectF(rect()).center(), 0.8);
}

void PlanView::panBy(const QPointF& by_px) {
    corner_ -= by_px / scale_;
    framing_ = Framing::Own;
    keepInReach();
    update();
}

/// Keeps part of the drawing in view, so that the user does not get lost.
void PlanView::keepInReach() {
    const QRectF all = layout().bounds();
    const QPointF room = QPointF(width(), height()) / scale_;
    const QPointF rest(std::min(room.x(), all.width()) / 4.0, std::min(room.y(), all.height()) / 4.0);
    corner_.rx() = std::clamp(corner_.x(), all.left() - room.x() + rest.x(), all.right() - rest.x());
    corner_.ry() = std::clamp(corner_.y(), all.top() - room.y() + rest.y(), all.bottom() - rest.y());
}

/// Scrolls no further than necessary; shows the beginning of a part that is larger than the view.
void PlanView::bringIntoView(int node) {
    const QRectF box = layout().box(tree_, node).adjusted(-margin_px, -margin_px, margin_px, margin_px);
    const QPointF room = QPointF(width(), height()) / scale_;
    const auto moved = [](double corner, double length, double from, double to) {
        return std::min(std::max(corner, to - length), from);
    };
    const QPointF before = corner_;
    corner_ = {moved(corner_.x(), room.x(), box.left(), box.right()),
               moved(corner_.y(), room.y(), box.top(), box.bottom())};
    if (corner_ != before)
        framing_ = Framing::Own;
    update();
}

QString PlanView::nodeText(int node) const {
    const PlanNode& what = tree_[node];
    const PlanActivity& state = states_[node];
    QStringList lines{planKindWord(what.kind) + u' ' + what.name +
                      (what.detail.isEmpty() ? QString() : QStringLiteral(", ") + what.detail)};
    if (what.level >= 0)
        lines << (what.has_equals ? tr("Priority %1, with equals").arg(what.level + 1)
                                  : tr("Priority %1").arg(what.level + 1));
    if (!what.comment.isEmpty())
        lines << what.comment;
    if (what.kind == PlanNodeKind::Sense)
        lines << (state.answer ? tr("Newest answer: %1").arg(answerText(state, states_.now())) : tr("Not asked yet"));
    else
        lines << lastRunText(state, states_.now());
    if (const QString counters = countersText(state); !counters.isEmpty())
        lines << counters;
    if (const PlanMark* const mark = marks_.at(node))
        lines << mark->words;
    if (what.link >= 0)
        lines << (what.recursive ? tr("Leads back to where it stands; the plan cannot run so")
                                 : tr("Drawn in full elsewhere; Return goes there"));
    if (folds_.folded(tree_, node))
        lines << tr("%1 parts are folded away").arg(what.end - node - 1 - what.senses);
    if (what.at.line > 0)
        lines << tr("Line %1, column %2").arg(what.at.line).arg(what.at.column);
    return lines.join(u'\n');
}

QString PlanView::reservation() const {
    if (states_.strangers() > 0)
        return tr("Parts of what runs that are not in this plan: %1. Load the plan anew").arg(states_.strangers());
    if (tree_.truncated())
        return tr("More than %1 parts: some shared ones are links").arg(PlanTree::most_nodes);
    return {};
}

/// Describes the selected part for screen readers, or the keys if nothing is selected.
void PlanView::describe() {
    setAccessibleDescription(
        selected_ >= 0 ? nodeText(selected_)
                       : tr("Ctrl with arrow keys walks over the parts, arrow keys pan, plus and minus zoom, Space "
                            "folds, N goes to what runs."));
}

QSizeF PlanView::drawingSize() {
    return layout().bounds().size() + QSizeF(2.0 * margin_px, 2.0 * margin_px);
}

void PlanView::paintDrawing(QPainter& painter) {
    const QRectF area = layout().bounds().adjusted(-margin_px, -margin_px, margin_px, margin_px);
    painter.translate(-area.topLeft());
    const PlanScene scene{tree_, layout_, folds_, states_, tokens(Theme::Light)};
    PlanPainter(painter, scene, 1.0).paint(area);
}

void PlanView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    painter.fillRect(event->rect(), tokens().background);
    if (tree_.empty())
        return;
    const QRectF area(toLayout(event->rect().topLeft()), QSizeF(event->rect().size()) / scale_);
    layout(); // Updates layout_ if necessary.
    painter.scale(scale_, scale_);
    painter.translate(-corner_);
    const PlanScene scene{tree_,        layout_,   folds_, states_,    tokens(),
                          found_marks_, selected_, hot_,   hasFocus(), &marks_};
    PlanPainter(painter, scene, scale_).paint(area.adjusted(-8.0, -8.0, 8.0, 8.0));
    painter.resetTransform();
    if (const QString note = reservation(); !note.isEmpty())
        paintSheetNote(painter, {double(gap::small), double(height() - gap::small)}, note);
    if (hasFocus()) {
        painter.setPen(QPen(tokens().accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace usar::widgets
