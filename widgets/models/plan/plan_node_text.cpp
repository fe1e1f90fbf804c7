#include "widgets/models/plan/plan_node_text.h"

#include <QObject>
#include <QStringList>

#include "widgets/models/plan/plan_reasons.h"

namespace usar::widgets {

QString planNodeText(const PlanTree& tree, const PlanStates& states, const PlanFolds& folds, const PlanMarks& marks,
                     int node) {
    const PlanNode& what = tree[node];
    const PlanActivity& state = states[node];
    QStringList lines{planKindWord(what.kind) + u' ' + what.name +
                      (what.detail.isEmpty() ? QString() : QStringLiteral(", ") + what.detail)};
    if (what.level >= 0)
        lines << (what.has_equals ? QObject::tr("Priority %1, with equals").arg(what.level + 1)
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
    if (what.link >= 0)
        lines << (what.recursive ? QObject::tr("Leads back to where it stands; the plan cannot run so")
                                 : QObject::tr("Drawn in full elsewhere; Return goes there"));
    if (folds.folded(tree, node))
        lines << QObject::tr("%1 parts are folded away").arg(what.end - node - 1 - what.senses);
    if (what.at.line > 0)
        lines << QObject::tr("Line %1, column %2").arg(what.at.line).arg(what.at.column);
    return lines.join(u'\n');
}

QString planReservation(const PlanTree& tree, const PlanStates& states) {
    if (states.strangers() > 0)
        return QObject::tr("Parts of what runs that are not in this plan: %1. Load the plan anew")
            .arg(states.strangers());
    if (tree.truncated())
        return QObject::tr("More than %1 parts: some shared ones are links").arg(PlanTree::most_nodes);
    return {};
}

} // namespace usar::widgets
