#include "widgets/models/plan/plan_node_text.h"

#include <QObject>
#include <QStringList>

#include "widgets/models/plan/plan_reasons.h"

namespace usar::widgets {

QString planNodeText(const PlanTree& tree, const PlanStates& states, const PlanFolds& folds, const PlanMarks& marks,
                     PlanNodeId node) {
    const PlanNode& what = tree[node];
    const PlanActivity& state = states[node];
    QStringList lines{planKindWord(what.kind) + u' ' + what.name +
                      (what.detail.isEmpty() ? QString() : QStringLiteral(", ") + what.detail)};
    if (what.level >= 0)
        lines << (what.has_equals ? QObject::tr("Priority %1, shared with others").arg(what.level + 1)
                                  : QObject::tr("Priority %1").arg(what.level + 1));
    if (!what.comment.isEmpty())
        lines << what.comment;
    if (what.kind == PlanNodeKind::Sense)
        lines << (state.answer ? QObject::tr("Newest answer: %1").arg(answerText(state, states.now()))
                               : QObject::tr("Not asked yet"));
    else
        lines << lastRunText(state, states.now());
    if (const QString counters = countersText(state); !counters.isEmpty())
        lines << counters;
    if (const PlanMark* const mark = marks.at(node))
        lines << mark->words;
    if (what.link.valid())
        lines << (what.recursive ? QObject::tr("Leads back to a part that contains it, so the plan cannot run")
                                 : QObject::tr("Drawn in full elsewhere; press Return to go there"));
    if (folds.folded(tree, node))
        lines << QObject::tr("Folded parts: %1").arg(tree.countBelow(node));
    if (what.at.line > 0)
        lines << QObject::tr("Line %1, column %2").arg(what.at.line).arg(what.at.column);
    return lines.join(u'\n');
}

QString planReservation(const PlanTree& tree, const PlanStates& states) {
    if (states.strangers() > 0)
        return QObject::tr("Running parts that are not in this plan: %1. Load the plan again").arg(states.strangers());
    if (tree.truncated())
        return QObject::tr("More than %1 parts: some shared parts are drawn as links").arg(PlanTree::most_nodes);
    return {};
}

} // namespace usar::widgets
