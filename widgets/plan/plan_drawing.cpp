#include "widgets/plan/plan_drawing.h"

#include <utility>

namespace usar::widgets {

const PlanLayout& PlanDrawing::layout() {
    if (!valid_)
        lay();
    return layout_;
}

void PlanDrawing::lay() {
    if (sizes_.size() != static_cast<std::size_t>(tree_.size())) {
        const PlanMetrics metrics = planMetrics();
        row_px_ = metrics.row_px;
        sizes_ = measurePlan(tree_, metrics);
    }
    layout_ = PlanLayout(tree_, folds_, sizes_, row_px_, wantedFlow());
    valid_ = true;
}

PlanTree PlanDrawing::setPlan(const posh::Plan& plan) {
    plan_ = plan;
    return remake();
}

PlanTree PlanDrawing::setSharing(PlanSharing sharing) {
    sharing_ = sharing;
    return remake();
}

PlanTree PlanDrawing::remake() {
    forgetSizes();
    return std::exchange(tree_, PlanTree(plan_, sharing_));
}

void PlanDrawing::forgetSizes() {
    sizes_.clear();
    valid_ = false;
}

bool PlanDrawing::turn() {
    if (!valid_ || layout_.flow() == wantedFlow())
        return false;
    valid_ = false;
    return true;
}

std::optional<QPointF> PlanDrawing::refold(PlanNodeId held, const std::function<bool(PlanFolds&)>& change) {
    const bool known = valid_ && held.valid();
    const QPointF before = known ? layout_.box(tree_, held).topLeft() : QPointF();
    if (!change(folds_))
        return std::nullopt;
    lay();
    return known && !hides(held) ? layout_.box(tree_, held).topLeft() - before : QPointF();
}

PlanNodeId PlanDrawing::nodeAt(const QPointF& place, PlanDetail detail) {
    const PlanNodeId node = layout().nodeAt(tree_, place);
    return node.valid() && detail != PlanDetail::Full ? tree_.cardOf(node) : node;
}

bool PlanDrawing::onFoldMark(PlanNodeId node, const QPointF& place, PlanDetail detail) {
    if (tree_[node].in_card || (tree_.children(node).empty() && !tree_[node].link.valid()) ||
        detail != PlanDetail::Full)
        return false;
    const QRectF box = layout().box(tree_, node);
    return QRectF(box.right() - plan_card::fold_px, box.top(), plan_card::fold_px, row_px_ + plan_card::padding_px)
        .contains(place);
}

} // namespace usar::widgets
