#include "widgets/models/plan/plan_layout.h"

#include <algorithm>

namespace usar::widgets {

namespace {

constexpr double column_gap_px = 36.0;
constexpr double indent_px = 24.0;
constexpr double equals_gap_px = 4.0; ///< between members of a level, and between steps
constexpr double level_gap_px = 12.0;

std::size_t at(int node) {
    return static_cast<std::size_t>(node);
}

double widthOf(const PlanTree& tree, int node, const PlanMetrics& metrics) {
    using namespace plan_card;
    const PlanNode& card = tree[node];
    double width = 2.0 * padding_px + glyph_px + metrics.name_px(card.name);
    if (!card.detail.isEmpty())
        width += padding_px + metrics.text_px(card.detail);
    if (card.kind != PlanNodeKind::Plan)
        width += padding_px + (card.kind == PlanNodeKind::Sense ? answer_px : counters_px);
    if (!tree.children(node).empty() || card.link >= 0)
        width += fold_px;
    for (int sense = node + 1; sense <= node + card.senses; ++sense) {
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

std::vector<QSizeF> measurePlan(const PlanTree& tree, const PlanMetrics& metrics) {
    std::vector<QSizeF> sizes(at(tree.size()));
    for (int node = 0; node < tree.size(); ++node)
        if (!tree[node].in_card)
            sizes[at(node)] = {widthOf(tree, node, metrics),
                               metrics.row_px * (1 + tree[node].senses) + plan_card::padding_px};
    return sizes;
}

PlanLayout::PlanLayout(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes, double row_px,
                       PlanFlow flow)
    : flow_(flow)
    , row_px_(row_px)
    , boxes_(at(tree.size()))
    , bands_(at(tree.size())) {
    for (int node = 0; node < tree.size(); node = tree[node].end)
        roots_.push_back(node);
    place(tree, folds, sizes, bandHeights(tree, folds, sizes));
    uniteBands(tree);
    for (const int root : roots_)
        bounds_ = bounds_.united(bands_[at(root)]);
}

/// Returns the gap above the sibling at index `before`.
double PlanLayout::gap(const PlanTree& tree, std::span<const int> siblings, std::size_t before) const {
    if (before == 0)
        return flow_ == PlanFlow::Across ? 0.0 : equals_gap_px;
    const bool same_level = tree[siblings[before]].level == tree[siblings[before - 1]].level;
    return same_level ? equals_gap_px : level_gap_px;
}

std::vector<double> PlanLayout::bandHeights(const PlanTree& tree, const PlanFolds& folds,
                                            const std::vector<QSizeF>& sizes) const {
    std::vector<double> heights(at(tree.size()), 0.0);
    for (int node = tree.size(); node-- > 0;) {
        double below = 0.0;
        if (const auto children = tree.children(node); !children.empty() && !folds.folded(tree, node))
            for (std::size_t i = 0; i < children.size(); ++i)
                below += gap(tree, children, i) + heights[at(children[i])];
        const double own = sizes[at(node)].height();
        heights[at(node)] = flow_ == PlanFlow::Across ? std::max(own, below) : own + below;
    }
    return heights;
}

void PlanLayout::place(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes,
                       const std::vector<double>& heights) {
    const auto placeColumn = [&](std::span<const int> cards, QPointF corner) {
        double width = 0.0;
        for (const int card : cards)
            width = std::max(width, sizes[at(card)].width());
        for (std::size_t i = 0; i < cards.size(); ++i) {
            corner.ry() += gap(tree, cards, i);
            boxes_[at(cards[i])] = {corner, QSizeF(width, sizes[at(cards[i])].height())};
            corner.ry() += heights[at(cards[i])];
        }
    };
    placeColumn(roots_, {});
    for (int node = 0; node < tree.size(); ++node) {
        const QRectF& box = boxes_[at(node)];
        if (box.isNull() || tree.children(node).empty() || folds.folded(tree, node))
            continue;
        placeColumn(tree.children(node), flow_ == PlanFlow::Across ? QPointF(box.right() + column_gap_px, box.top())
                                                                   : QPointF(box.left() + indent_px, box.bottom()));
    }
}

void PlanLayout::uniteBands(const PlanTree& tree) {
    for (int node = tree.size(); node-- > 0;) {
        if (!shown(node))
            continue;
        bands_[at(node)] = bands_[at(node)].united(boxes_[at(node)]);
        if (const int parent = tree[node].parent; parent >= 0)
            bands_[at(parent)] = bands_[at(parent)].united(bands_[at(node)]);
    }
}

QRectF PlanLayout::box(const PlanTree& tree, int node) const {
    const PlanNode& what = tree[node];
    if (!what.in_card)
        return boxes_[at(node)];
    const QRectF& card = boxes_[at(what.parent)];
    if (card.isNull())
        return {};
    const int row = node - what.parent; // Senses directly follow their card, the first one is below its title.
    return {card.left(), card.top() + plan_card::padding_px / 2.0 + row_px_ * row, card.width(), row_px_};
}

QPointF PlanLayout::exit(int node) const {
    const QRectF& box = boxes_[at(node)];
    const double title_middle = box.top() + (plan_card::padding_px + row_px_) / 2.0;
    return flow_ == PlanFlow::Across ? QPointF(box.right(), title_middle)
                                     : QPointF(box.left() + indent_px / 2.0, box.bottom());
}

QPointF PlanLayout::entry(int node) const {
    const QRectF& box = boxes_[at(node)];
    return {box.left(), box.top() + (plan_card::padding_px + row_px_) / 2.0};
}

std::size_t PlanLayout::firstBelow(std::span<const int> children, double top) const {
    const auto first = std::partition_point(
        children.begin(), children.end(), [&](int child) { return shown(child) && bands_[at(child)].bottom() < top; });
    return static_cast<std::size_t>(first - children.begin());
}

int PlanLayout::nodeAt(const PlanTree& tree, const QPointF& point) const {
    int found = -1;
    for (const int node : nodesIn(tree, QRectF(point - QPointF(0.25, 0.25), QSizeF(0.5, 0.5))))
        if (boxes_[at(node)].contains(point))
            found = node;
    if (found < 0)
        return -1;
    const int senses = tree[found].senses;
    for (int sense = found + 1; sense <= found + senses; ++sense)
        if (box(tree, sense).contains(point))
            return sense;
    return found;
}

std::vector<int> PlanLayout::nodesIn(const PlanTree& tree, const QRectF& area) const {
    std::vector<int> nodes;
    std::vector<int> open(roots_.rbegin(), roots_.rend());
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        if (!shown(node) || !bands_[at(node)].intersects(area))
            continue;
        nodes.push_back(node);
        const std::span<const int> children = tree.children(node);
        const std::size_t first = firstBelow(children, area.top());
        std::size_t end = first;
        while (end < children.size() && bands_[at(children[end])].top() <= area.bottom() && shown(children[end]))
            ++end;
        for (std::size_t i = end; i-- > first;)
            open.push_back(children[i]);
    }
    return nodes;
}

} // namespace usar::widgets
