// The drawing of a plan: its tree, its folded parts, and the position of each card.
#pragma once

#include <functional>
#include <optional>

#include "core/posh/model/plan.h"
#include "widgets/models/plan/plan_layout.h"
#include "widgets/plan/plan_painter.h"

namespace usar::widgets {

/// Computes the layout on demand, and again only after a change. Places are in pixels at a scale of 1. GUI
/// thread, because it measures fonts.
class PlanDrawing {
public:
    /// `usual_flow` is asked whenever the drawing is laid out and setFlow() has chosen none.
    explicit PlanDrawing(std::function<PlanFlow()> usual_flow) : usual_flow_(std::move(usual_flow)) {}

    const PlanTree& tree() const { return tree_; }
    const PlanFolds& folds() const { return folds_; }
    const PlanLayout& layout();

    /// These two build another tree, in which parts with the same names stay folded. They return the previous tree.
    PlanTree setPlan(const posh::Plan& plan);
    PlanTree setSharing(PlanSharing sharing);
    PlanSharing sharing() const { return sharing_; }
    /// nullopt selects the usual flow. Call turn() for it to take effect immediately.
    void setFlow(std::optional<PlanFlow> flow) { flow_ = flow; }
    /// Takes effect with the next tree.
    void forgetFolds() { folds_.unfoldAll(); }
    /// Forgets the measured sizes, because the fonts may have changed.
    void forgetSizes();
    /// Forgets the layout and returns true if another flow is now wanted.
    bool turn();
    /// Changes what is folded. If `change` returns true, lays out again and returns by how much the node `held` has
    /// moved; 0 for none, and if it is folded away or was not laid out before. Else returns nullopt.
    std::optional<QPointF> refold(PlanNodeId held, const std::function<bool(PlanFolds&)>& change);

    /// True if the node is folded away.
    bool hides(PlanNodeId node) { return layout().box(tree_, node).isNull(); }
    /// The node at that place, or its card if its row is not drawn at this level of detail.
    PlanNodeId nodeAt(const QPointF& place, PlanDetail detail);
    /// True if that place is on the node's fold mark or link arrow, and it is drawn at this level of detail.
    bool onFoldMark(PlanNodeId node, const QPointF& place, PlanDetail detail);

private:
    PlanTree remake();
    PlanFlow wantedFlow() const { return flow_ ? *flow_ : usual_flow_(); }
    void lay();

    std::function<PlanFlow()> usual_flow_;
    std::optional<PlanFlow> flow_;
    posh::Plan plan_;
    PlanSharing sharing_ = PlanSharing::Once;
    PlanTree tree_;
    PlanFolds folds_;
    std::vector<QSizeF> sizes_; ///< sizes of the cards; empty: not measured yet
    double row_px_ = 20.0;      ///< height of a title or sense
    PlanLayout layout_;
    bool valid_ = false;
};

} // namespace usar::widgets
