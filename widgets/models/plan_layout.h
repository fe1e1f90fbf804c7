// Where each card of a drawn plan stands, what is at a point, and what is in a rectangle.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>

#include "widgets/models/plan_folds.h"
#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// How wide texts are, in pixels at a scale of 1.
struct PlanMetrics {
    std::function<double(const QString&)> name_px; ///< of a card's title
    std::function<double(const QString&)> text_px; ///< of everything else
    double row_px = 20.0;                          ///< height of the title, and of each sense
};

/// The parts of a card, in pixels from its corner. Painting and layout agree on them.
namespace plan_card {
inline constexpr double padding_px = 8.0;
inline constexpr double glyph_px = 20.0;    ///< room of the mark in front of a title or sense
inline constexpr double counters_px = 72.0; ///< room of the counters behind a title
inline constexpr double answer_px = 56.0;   ///< room of a sense's newest answer
inline constexpr double goal_px = 34.0;     ///< room of the word "goal" in front of a goal's sense
inline constexpr double fold_px = 36.0;     ///< room of the fold mark of what has something below it
inline constexpr double widest_px = 420.0;  ///< longer texts are cut; the tooltip has them
} // namespace plan_card

/// Natural width and height of each card (zero for senses inside one).
std::vector<QSizeF> measurePlan(const PlanTree& tree, const PlanMetrics& metrics);

/// What grows to the right: cards of children (broad views), or only an indent, as in an outline (narrow docks).
enum class PlanFlow { Across, Down };

/// Deterministic and linear in the number of nodes: every subtree has a band of its own, its card at the top left of
/// it, so that branches never interleave and children read from top to bottom in order of priority. Siblings are
/// equally wide. In pixels at a scale of 1; the first card is at the origin.
class PlanLayout {
public:
    PlanLayout() = default;
    PlanLayout(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes, double row_px,
               PlanFlow flow);

    PlanFlow flow() const { return flow_; }
    /// All cards.
    const QRectF& bounds() const { return bounds_; }
    /// Of a card, or of a sense's row in it. Null for what is folded away.
    QRectF box(const PlanTree& tree, int node) const;
    bool shown(int node) const { return !boxes_[static_cast<std::size_t>(node)].isNull(); }
    /// Where the line from a card leaves it, and where that to it arrives.
    QPointF exit(int node) const;
    QPointF entry(int node) const;

    /// The sense row or card there; -1 for none. Logarithmic in the number of siblings.
    int nodeAt(const PlanTree& tree, const QPointF& point) const;
    /// Cards that a rectangle touches, and cards with lines to children in it, in the order of the tree. `visit(node)`;
    /// costs as much as it finds.
    template <class Visit>
    void forEachIn(const PlanTree& tree, const QRectF& area, Visit&& visit) const;
    std::vector<int> nodesIn(const PlanTree& tree, const QRectF& area) const;

private:
    double gap(const PlanTree& tree, std::span<const int> siblings, std::size_t before) const;
    std::vector<double> bandHeights(const PlanTree& tree, const PlanFolds& folds,
                                    const std::vector<QSizeF>& sizes) const;
    void place(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes,
               const std::vector<double>& heights);
    void uniteBands(const PlanTree& tree);
    /// The first child whose band ends below `top`.
    std::size_t firstBelow(std::span<const int> children, double top) const;

    PlanFlow flow_ = PlanFlow::Across;
    double row_px_ = 20.0;
    std::vector<QRectF> boxes_; ///< null: folded away, or inside a card
    std::vector<QRectF> bands_; ///< of the card and all below it
    std::vector<int> roots_;
    QRectF bounds_;
};

template <class Visit>
void PlanLayout::forEachIn(const PlanTree& tree, const QRectF& area, Visit&& visit) const {
    std::vector<int> open(roots_.rbegin(), roots_.rend());
    while (!open.empty()) {
        const int node = open.back();
        open.pop_back();
        if (!shown(node) || !bands_[static_cast<std::size_t>(node)].intersects(area))
            continue;
        visit(node);
        const std::span<const int> children = tree.children(node);
        const std::size_t first = firstBelow(children, area.top());
        std::size_t end = first;
        while (end < children.size() && bands_[static_cast<std::size_t>(children[end])].top() <= area.bottom() &&
               shown(children[end]))
            ++end;
        for (std::size_t i = end; i-- > first;)
            open.push_back(children[i]);
    }
}

} // namespace usar::widgets
