// Draws a plan: cards, the lines between them, what is running, and the answers of senses. Used for screen and paper.
#pragma once

#include <algorithm>
#include <vector>

#include <QFont>
#include <QPainter>

#include "widgets/models/plan/plan_activity.h"
#include "widgets/models/plan/plan_layout.h"
#include "widgets/models/plan/plan_marks.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

/// Everything that a drawing is made of; the references must outlive the painter.
struct PlanScene {
    const PlanTree& tree;
    const PlanLayout& layout;
    const PlanFolds& folds;
    const PlanStates& states;
    const Tokens& colors;
    std::vector<bool> found{}; ///< by node: true if it matches the search; empty: no search
    PlanNodeId selected{};
    PlanNodeId hot{};                 ///< under the mouse
    bool focused = false;             ///< the view has the keyboard focus
    const PlanMarks* marks = nullptr; ///< nullptr: no marks
};

/// Level of detail that a scale has room for: everything; blocks with names; blocks only.
enum class PlanDetail { Full, Names, Blocks };
/// Level of detail for a number of screen pixels per layout pixel.
PlanDetail planDetailAt(double scale);

/// Text widths in the fonts of the drawing. GUI thread.
PlanMetrics planMetrics();

/// The painter's transform maps layout pixels to the device; `scale` is the number of device pixels per layout pixel.
class PlanPainter {
public:
    PlanPainter(QPainter& painter, const PlanScene& scene, double scale);
    /// Paints everything in `area`, given in layout pixels.
    void paint(const QRectF& area);

private:
    /// Paints the lines from these cards to their parents and children.
    void paintLines(const std::vector<PlanNodeId>& nodes, const QRectF& area);
    /// The x of the vertical part of a line from a card to one of its children.
    double trunkOf(const QPointF& from, const QPointF& to) const;
    void paintEquals(PlanNodeId node);
    void paintCard(PlanNodeId node);
    void paintBlockName(PlanNodeId node, const QRectF& box);
    void paintTitle(PlanNodeId node, const QRectF& row);
    void paintNameAndDetail(const PlanNode& what, const QFont& name_font, const QRectF& room, double gap_px,
                            double least_px);
    void paintKindMark(PlanNodeId node, const QRectF& place);
    /// The two return the right edge of the room that is left for the title.
    double paintCounters(PlanNodeId node, const QRectF& row, double right);
    double paintFoldMark(PlanNodeId node, const QRectF& row, double right);
    void paintSenseRow(PlanNodeId sense);
    double paintAnswer(PlanNodeId sense, const QRectF& row);
    void paintVerdict(PlanNodeId sense, const QRectF& place);
    void paintFrames(PlanNodeId node);
    void paintMarks(PlanNodeId node);
    /// These paint one mark each, centered on a point of the card's edge.
    void paintBreakpoint(const PlanMark& mark, const QPointF& middle);
    void paintStand(const QPointF& middle);
    void paintPin(const QPointF& middle);
    void paintOff(const QRectF& box);
    void frame(const QRectF& box, const QColor& color, Qt::PenStyle style);
    void text(const QRectF& place, const QString& words, const QColor& color, Qt::Alignment align = Qt::AlignLeft);
    /// Background of a card: brighter under the mouse, tinted while it runs and for some time afterwards.
    QColor fillOf(PlanNodeId node) const;
    QRectF boxOf(PlanNodeId node) const { return scene_.layout.box(scene_.tree, node); }
    /// Line width of at least one device pixel.
    double thin() const { return 1.0 / std::min(scale_, 1.0); }
    /// Scale of marks, which shrink less than cards do.
    double markSize() const { return 1.0 / std::min(1.0, scale_ + 0.3); }

    QPainter& painter_;
    const PlanScene& scene_;
    const Tokens& colors_;
    double scale_;
    PlanDetail detail_;
    QFont name_font_;
    QFont text_font_;
};

} // namespace usar::widgets
