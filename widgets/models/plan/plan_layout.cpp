#include "widgets/models/plan/plan_layout.h"

#include <algorithm>
#include <iterator>

namespace usar::widgets {

namespace {

constexpr double column_gap_px = 36.0;
constexpr double indent_px = 24.0;
constexpr double equals_gap_px = 4.0; ///< between members of a level, and between steps
constexpr double level_gap_px = 12.0;

double widthOf(const PlanTree& tree, PlanNodeId node, const PlanMetrics& metrics) {
    using namespace plan_card;
    const PlanNode& card = tree[node];
    double width = 2.0 * padding_px + glyph_px + metrics.name_px(card.name);
    if (!card.detail.isEmpty())
        width += padding_px + metrics.text_px(card.detail);
    if (card.kind != PlanNodeKind::Plan)
        width += padding_px + (card.kind == PlanNodeKind::Sense ? answer_px : counters_px);
    if (!tree.children(node).empty() || card.link.valid())
        width += fold_px;
    for (const PlanNodeId sense : tree.senses(node)) {
        double row = 2.0 * padding_px + glyph_px + metrics.text_px(tree[sense].name) + padding_px + answer_px;
        if (tree[sense].of_goal)
            row += goal_px;
        if (!tree[sense].detail.isEmpty())
            row += padding_px + metrics.text_px(tree[sense].detail);
        width = std::max(width, row);
    }
    return std::min(width, widest_px);
}

} // namespace

void PlanFolds::set(const PlanTree& tree, PlanNodeId node, bool folded) {
    if (folded && !tree.children(node).empty())
        keys_.insert(tree[node].key);
    else
        keys_.erase(tree[node].key);
}

void PlanFolds::foldAll(const PlanTree& tree) {
    for (const PlanNodeId node : tree.nodes())
        if (tree[node].parent.valid())
            set(tree, node, true);
}

void PlanFolds::showOnly(const PlanTree& tree, const std::vector<PlanNodeId>& nodes) {
    foldAll(tree);
    for (const PlanNodeId node : nodes)
        reveal(tree, node);
}

bool PlanFolds::reveal(const PlanTree& tree, PlanNodeId node) {
    bool changed = false; // A sense is visible if its card is.
    for (PlanNodeId at = tree[tree.cardOf(node)].parent; at.valid(); at = tree[at].parent)
        changed = keys_.erase(tree[at].key) > 0 || changed;
    return changed;
}

std::vector<QSizeF> measurePlan(const PlanTree& tree, const PlanMetrics& metrics) {
    std::vector<QSizeF> sizes(static_cast<std::size_t>(tree.size()));
    for (const PlanNodeId node : tree.nodes())
        if (!tree[node].in_card)
            sizes[node.index()] = {widthOf(tree, node, metrics),
                                   metrics.row_px * (1 + tree[node].senses) + plan_card::padding_px};
    return sizes;
}

PlanLayout::PlanLayout(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes, double row_px,
                       PlanFlow flow)
    : flow_(flow)
    , row_px_(row_px)
    , boxes_(static_cast<std::size_t>(tree.size()))
    , bands_(static_cast<std::size_t>(tree.size())) {
    for (PlanNodeId node{0}; tree.contains(node); node = tree[node].end)
        roots_.push_back(node);
    place(tree, folds, sizes, bandHeights(tree, folds, sizes));
    uniteBands(tree);
    for (const PlanNodeId root : roots_)
        bounds_ = bounds_.united(bands_[root.index()]);
}

/// Returns the gap above the sibling at index `before`.
double PlanLayout::gap(const PlanTree& tree, std::span<const PlanNodeId> siblings, std::size_t before) const {
    if (before == 0)
        return flow_ == PlanFlow::Across ? 0.0 : equals_gap_px;
    const bool same_level = tree[siblings[before]].level == tree[siblings[before - 1]].level;
    return same_level ? equals_gap_px : level_gap_px;
}

std::vector<double> PlanLayout::bandHeights(const PlanTree& tree, const PlanFolds& folds,
                                            const std::vector<QSizeF>& sizes) const {
    std::vector<double> heights(static_cast<std::size_t>(tree.size()), 0.0);
    for (const PlanNodeId node : tree.nodes() | std::views::reverse) {
        double below = 0.0;
        if (const auto children = tree.children(node); !children.empty() && !folds.folded(tree, node))
            for (std::size_t i = 0; i < children.size(); ++i)
                below += gap(tree, children, i) + heights[children[i].index()];
        const double own = sizes[node.index()].height();
        heights[node.index()] = flow_ == PlanFlow::Across ? std::max(own, below) : own + below;
    }
    return heights;
}

void PlanLayout::place(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes,
                       const std::vector<double>& heights) {
    const auto placeColumn = [&](std::span<const PlanNodeId> cards, QPointF corner) {
        double width = 0.0;
        for (const PlanNodeId card : cards)
            width = std::max(width, sizes[card.index()].width());
        for (std::size_t i = 0; i < cards.size(); ++i) {
            corner.ry() += gap(tree, cards, i);
            boxes_[cards[i].index()] = {corner, QSizeF(width, sizes[cards[i].index()].height())};
            corner.ry() += heights[cards[i].index()];
        }
    };
    placeColumn(roots_, {});
    for (const PlanNodeId node : tree.nodes()) {
        const QRectF& box = boxes_[node.index()];
        if (box.isNull() || tree.children(node).empty() || folds.folded(tree, node))
            continue;
        placeColumn(tree.children(node), flow_ == PlanFlow::Across ? QPointF(box.right() + column_gap_px, box.top())
                                                                   : QPointF(box.left() + indent_px, box.bottom()));
    }
}

void PlanLayout::uniteBands(const PlanTree& tree) {
    for (const PlanNodeId node : tree.nodes() | std::views::reverse) {
        if (!shown(node))
            continue;
        bands_[node.index()] = bands_[node.index()].united(boxes_[node.index()]);
        if (const PlanNodeId parent = tree[node].parent; parent.valid())
            bands_[parent.index()] = bands_[parent.index()].united(bands_[node.index()]);
    }
}

QRectF PlanLayout::box(const PlanTree& tree, PlanNodeId node) const {
    const PlanNode& what = tree[node];
    if (!what.in_card)
        return boxes_[node.index()];
    const QRectF& card = boxes_[what.parent.index()];
    if (card.isNull())
        return {};
    // Senses directly follow their card, the first one is below its title.
    const int row = node.value - what.parent.value;
    return {card.left(), card.top() + plan_card::padding_px / 2.0 + row_px_ * row, card.width(), row_px_};
}

QPointF PlanLayout::exit(PlanNodeId node) const {
    const QRectF& box = boxes_[node.index()];
    const double title_middle = box.top() + (plan_card::padding_px + row_px_) / 2.0;
    return flow_ == PlanFlow::Across ? QPointF(box.right(), title_middle)
                                     : QPointF(box.left() + indent_px / 2.0, box.bottom());
}

QPointF PlanLayout::entry(PlanNodeId node) const {
    const QRectF& box = boxes_[node.index()];
    return {box.left(), box.top() + (plan_card::padding_px + row_px_) / 2.0};
}

PlanNodeId PlanLayout::nodeAt(const PlanTree& tree, const QPointF& point) const {
    PlanNodeId found;
    for (const PlanNodeId node : nodesIn(tree, QRectF(point - QPointF(0.25, 0.25), QSizeF(0.5, 0.5))))
        if (boxes_[node.index()].contains(point))
            found = node;
    if (!found.valid())
        return {};
    for (const PlanNodeId sense : tree.senses(found))
        if (box(tree, sense).contains(point))
            return sense;
    return found;
}

std::vector<PlanNodeId> PlanLayout::nodesIn(const PlanTree& tree, const QRectF& area) const {
    std::vector<PlanNodeId> nodes;
    std::vector<PlanNodeId> open(roots_.rbegin(), roots_.rend());
    while (!open.empty()) {
        const PlanNodeId node = open.back();
        open.pop_back();
        if (!shown(node) || !bands_[node.index()].intersects(area))
            continue;
        nodes.push_back(node);
        const std::span<const PlanNodeId> children = tree.children(node);
        const auto first = std::ranges::partition_point(
            children, [&](PlanNodeId child) { return shown(child) && bands_[child.index()].bottom() < area.top(); });
        auto end = first;
        while (end != children.end() && bands_[end->index()].top() <= area.bottom() && shown(*end))
            ++end;
        open.insert(open.end(), std::make_reverse_iterator(end), std::make_reverse_iterator(first));
    }
    return nodes;
}

} // namespace usar::widgets
