// Folds and layout of a drawn plan: which parts are folded, where each card is, and which nodes are at a point or in a
// rectangle.
#pragma once

#include <functional>
#include <span>
#include <unordered_set>
#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>

#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// The folded parts, stored by the names on the path to them, so that folds survive an edit. Nodes without children
/// cannot be folded.
class PlanFolds {
public:
    /// True if the node's children are hidden.
    bool folded(const PlanTree& tree, PlanNodeId node) const { return keys_.contains(tree[node].key); }
    /// Folds or unfolds; folding a node without children unfolds it.
    void set(const PlanTree& tree, PlanNodeId node, bool folded);
    void unfoldAll() { keys_.clear(); }
    /// Folds everything except the roots.
    void foldAll(const PlanTree& tree);
    /// Folds everything except the paths to these nodes.
    void showOnly(const PlanTree& tree, const std::vector<PlanNodeId>& nodes);
    /// Unfolds everything that contains the node. Returns true if something was folded.
    bool reveal(const PlanTree& tree, PlanNodeId node);
    bool operator==(const PlanFolds&) const = default;

private:
    std::unordered_set<std::uint64_t> keys_;
};

/// Measures the width of texts in pixels at a scale of 1.
struct PlanMetrics {
    std::function<double(const QString&)> name_px; ///< for the title of a card
    std::function<double(const QString&)> text_px; ///< for all other text
    double row_px = 20.0;                          ///< height of the title row and of each sense row
};

/// Dimensions of the parts of a card in pixels; shared by painting and layout.
namespace plan_card {
inline constexpr double padding_px = 8.0;   ///< distance of the contents from the border of a card
inline constexpr double glyph_px = 20.0;    ///< room for the mark before a title or sense
inline constexpr double counters_px = 72.0; ///< room for the counters after a title
inline constexpr double answer_px = 56.0;   ///< room for a sense's newest answer
inline constexpr double goal_px = 34.0;     ///< room for the word "goal" before a sense of a goal
inline constexpr double fold_px = 36.0;     ///< room for the fold mark of a card with children
inline constexpr double widest_px = 420.0;  ///< longer texts are elided; the tooltip shows them
} // namespace plan_card

/// Natural size of each card in pixels at a scale of 1; empty for senses inside a card.
std::vector<QSizeF> measurePlan(const PlanTree& tree, const PlanMetrics& metrics);

/// Direction in which children are placed: to the right of their parent (wide views), or below it with an indent, like
/// an outline (narrow docks).
enum class PlanFlow { Across, Down };

/// Deterministic and linear in the number of nodes. Every subtree has a band of its own with its card at the top left,
/// so branches never interleave, and children are in order of priority from top to bottom. Siblings are equally wide.
/// In pixels at a scale of 1; the first card is at the origin.
class PlanLayout {
public:
    PlanLayout() = default;
    PlanLayout(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes, double row_px,
               PlanFlow flow);

    PlanFlow flow() const { return flow_; }
    /// Bounding box of all cards.
    const QRectF& bounds() const { return bounds_; }
    /// Box of a card, or of a sense's row in its card; null if it is folded away.
    QRectF box(const PlanTree& tree, PlanNodeId node) const;
    /// False for folded nodes and for senses inside a card.
    bool shown(PlanNodeId node) const { return !boxes_[node.index()].isNull(); }
    /// Points where the line from a card to its children starts, and where the line from its parent ends.
    QPointF exit(PlanNodeId node) const;
    QPointF entry(PlanNodeId node) const;

    /// The sense row or card at that point, if there is one. Logarithmic in the number of siblings.
    PlanNodeId nodeAt(const PlanTree& tree, const QPointF& point) const;
    /// The cards whose subtree touches the rectangle, in the order of the tree; this includes cards that only have
    /// lines to children in it. The cost is proportional to the number of cards found.
    std::vector<PlanNodeId> nodesIn(const PlanTree& tree, const QRectF& area) const;

private:
    /// Vertical gap above the sibling at index `before`.
    double gap(const PlanTree& tree, std::span<const PlanNodeId> siblings, std::size_t before) const;
    /// Height of each node's subtree.
    std::vector<double> bandHeights(const PlanTree& tree, const PlanFolds& folds,
                                    const std::vector<QSizeF>& sizes) const;
    /// Sets the boxes of all visible cards.
    void place(const PlanTree& tree, const PlanFolds& folds, const std::vector<QSizeF>& sizes,
               const std::vector<double>& heights);
    /// Computes the bands from the boxes.
    void uniteBands(const PlanTree& tree);

    PlanFlow flow_ = PlanFlow::Across;
    double row_px_ = 20.0;
    std::vector<QRectF> boxes_; ///< null: folded away, or inside a card
    std::vector<QRectF> bands_; ///< bounding box of the card and everything below it
    std::vector<PlanNodeId> roots_;
    QRectF bounds_;
};

} // namespace usar::widgets
