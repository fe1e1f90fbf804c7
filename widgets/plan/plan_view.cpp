#include "widgets/plan/plan_view.h"

#include <QPaintEvent>
#include <QPainter>

#include "widgets/models/plan/plan_reasons.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

namespace {
constexpr int broad_node_px = 560; ///< narrower views show an outline
constexpr int tick_ms = 16;
} // namespace

PlanView::PlanView(QWidget* parent)
    : QWidget(parent)
    , drawing_([this] { return width() < broad_node_px ? PlanFlow::Down : PlanFlow::Across; })
    , empty_state_(
          new EmptyState(this, tr("No plan"),
                         tr("The plan of a robot appears here. Choose a behavior that is a plan, then start it."))) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Plan"));
    tick_.setSingleShot(true);
    tick_.setInterval(tick_ms);
    tick_.setTimerType(Qt::PreciseTimer);
    connect(&tick_, &QTimer::timeout, this, &PlanView::takeNews);
    const auto measureAgain = [this] {
        drawing_.forgetSizes();
        update();
    };
    onThemeChange(this, measureAgain);
    onThemeChange(this, measureAgain, QEvent::FontChange);
    describe();
}

void PlanView::setPlan(const posh::Plan& plan) {
    snapshot_ = {};
    news_ = false;
    const bool was_empty = tree().empty();
    takeTree(drawing_.setPlan(plan));
    if (was_empty || framing_ == Framing::Beginning)
        showBeginning();
}

void PlanView::clear() {
    snapshot_ = {};
    drawing_.forgetFolds();
    framing_ = Framing::Beginning;
    takeTree(drawing_.setPlan({}));
}

void PlanView::setSharing(PlanSharing sharing) {
    if (sharing != drawing_.sharing())
        takeTree(drawing_.setSharing(sharing));
}

void PlanView::takeTree(const PlanTree& before) {
    selection_.moveTo(tree(), before);
    states_.reset(tree());
    marks_ = PlanMarks(tree(), marks_by_path_);
    hot_ = {};
    empty_state_->setVisible(tree().empty());
    news_ = snapshot_.paths != nullptr;
    emit treeChanged();
    emit selectionChanged(selected());
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
    marks_ = PlanMarks(tree(), marks_by_path_);
    describe();
    update();
}

void PlanView::takeNews() {
    if (!news_ || !isVisible())
        return;
    news_ = false;
    states_.take(tree(), snapshot_);
    describe();
    emit refreshed();
    update();
}

void PlanView::setFlow(std::optional<PlanFlow> flow) {
    drawing_.setFlow(flow);
    if (drawing_.turn())
        showBeginning();
}

void PlanView::refold(PlanNodeId held, const std::function<bool(PlanFolds&)>& change) {
    const auto moved = drawing_.refold(held, change);
    if (!moved)
        return;
    zoom_.corner += *moved;
    zoom_.keepInReach(layout().bounds(), size());
    update();
}

void PlanView::setFolded(PlanNodeId node, bool folded) {
    refold(node, [&](PlanFolds& folds) { return folds.set(tree(), node, folded), true; });
    if (selectionIsHidden())
        select(node);
    describe();
}

void PlanView::foldAll() {
    drawing_.refold({}, [&](PlanFolds& folds) { return folds.foldAll(tree()), true; });
    showBeginning();
    if (selectionIsHidden())
        select({});
}

void PlanView::unfoldAll() {
    refold(selected(), [](PlanFolds& folds) { return folds.unfoldAll(), true; });
}

void PlanView::showRunning() {
    const std::vector<PlanNodeId> running = states_.running(tree());
    drawing_.refold({}, [&](PlanFolds& folds) { return folds.showOnly(tree(), running), true; });
    if (selectionIsHidden())
        select({});
    showBeginning();
    if (!running.empty())
        bringIntoView(running.back());
}

void PlanView::select(PlanNodeId node) {
    if (node.valid()) {
        refold(selected(), [&](PlanFolds& folds) { return folds.reveal(tree(), node); });
        bringIntoView(node);
    }
    if (selection_.set(node))
        emit selectionChanged(node);
    describe();
    update();
}

bool PlanView::selectPath(const std::string& path) {
    const PlanNodeId node = tree().find(path);
    if (node.valid())
        select(node);
    return node.valid();
}

int PlanView::find(const QString& words) {
    selection_.search(tree(), words);
    if (!selection_.isFound())
        findNext();
    update();
    return static_cast<int>(found().size());
}

void PlanView::findNext(bool backward) {
    if (const PlanNodeId node = selection_.nextFound(backward); node.valid())
        select(node);
}

void PlanView::fit() {
    if (layout().bounds().isEmpty())
        return;
    zoom_.fit(layout().bounds(), size());
    framing_ = Framing::Whole;
    update();
}

void PlanView::showBeginning() {
    zoom_.showBeginning(layout().bounds(), size());
    framing_ = Framing::Beginning;
    update();
}

void PlanView::zoomAt(const QPointF& on_screen, double factor) {
    zoom_.zoomAt(on_screen, factor);
    framing_ = Framing::Own;
    zoom_.keepInReach(layout().bounds(), size());
    update();
}

void PlanView::panBy(const QPointF& by_px) {
    zoom_.panBy(by_px);
    framing_ = Framing::Own;
    zoom_.keepInReach(layout().bounds(), size());
    update();
}

void PlanView::bringIntoView(PlanNodeId node) {
    if (zoom_.bringIntoView(layout().box(tree(), node), size()))
        framing_ = Framing::Own;
    update();
}

QString PlanView::nodeText(PlanNodeId node) const {
    return planNodeText(tree(), states_, folds(), marks_, node);
}

void PlanView::describe() {
    setAccessibleDescription(
        selected().valid() ? nodeText(selected())
                           : tr("Ctrl with arrow keys walks over the parts, arrow keys pan, plus and minus zoom, Space "
                                "folds, N goes to what runs."));
}

void PlanView::paintDrawing(QPainter& painter) {
    constexpr double margin = PanZoom::margin_px;
    const QRectF area = layout().bounds().adjusted(-margin, -margin, margin, margin);
    painter.translate(-area.topLeft());
    const PlanScene scene{tree(), layout(), folds(), states_, tokens(Theme::Light)};
    PlanPainter(painter, scene, 1.0).paint(area);
}

void PlanView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    painter.fillRect(event->rect(), tokens().background);
    if (tree().empty())
        return;
    const QRectF area(toLayout(event->rect().topLeft()), QSizeF(event->rect().size()) / scale());
    painter.scale(scale(), scale());
    painter.translate(-zoom_.corner);
    const PlanScene scene{.tree = tree(),
                          .layout = layout(),
                          .folds = folds(),
                          .states = states_,
                          .colors = tokens(),
                          .found = selection_.foundByNode(),
                          .selected = selected(),
                          .hot = hot_,
                          .focused = hasFocus(),
                          .marks = &marks_};
    PlanPainter(painter, scene, scale()).paint(area.adjusted(-8.0, -8.0, 8.0, 8.0));
    painter.resetTransform();
    if (const QString note = planReservation(tree(), states_); !note.isEmpty())
        paintSheetNote(painter, {double(gap::small), double(height() - gap::small)}, note);
    if (hasFocus()) {
        painter.setPen(QPen(tokens().accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace usar::widgets
