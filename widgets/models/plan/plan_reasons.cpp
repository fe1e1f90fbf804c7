#include "widgets/models/plan/plan_reasons.h"

#include <algorithm>

#include <QObject>
#include <QStringList>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

class ReasonCollector {
public:
    ReasonCollector(const PlanTree& tree, const PlanStates& states) : tree_(tree), states_(states) {}

    std::vector<PlanReason> collect(PlanNodeId node) {
        std::vector<PlanNodeId> way;
        for (PlanNodeId at = node; at.valid(); at = tree_[at].parent)
            way.push_back(at);
        for (auto at = way.rbegin(); at != way.rend(); ++at)
            explain(*at);
        return std::move(reasons_);
    }

private:
    void say(PlanVerdict verdict, PlanNodeId node, const QString& text, std::optional<Seconds> since = {}) {
        reasons_.push_back({verdict, text, node, since});
    }

    void explain(PlanNodeId node) {
        if (!states_[node].running) {
            explainRival(node);
            if (!states_[node].hold_back.isEmpty())
                say(PlanVerdict::No, node,
                    QObject::tr("%1 is held back by %2").arg(tree_[node].name, states_[node].hold_back));
        }
        for (const PlanNodeId sense : tree_.senses(node))
            explainSense(node, sense);
        const PlanNodeId parent = tree_[node].parent;
        // A sense that is a step of a pattern; those in the card of the parent were explained with it.
        if (tree_[node].kind == PlanNodeKind::Sense && !tree_[node].in_card)
            explainSense(parent, node);
    }

    /// Only one of several siblings runs, so another one may have taken precedence.
    void explainRival(PlanNodeId node) {
        const PlanNodeId parent = tree_[node].parent;
        if (!parent.valid())
            return;
        for (const PlanNodeId sibling : tree_.children(parent)) {
            if (sibling == node || !states_[sibling].running)
                continue;
            if (tree_[node].level < 0)
                say(sibling < node ? PlanVerdict::No : PlanVerdict::Open, sibling,
                    sibling < node
                        ? QObject::tr("%1 comes before it and is running now").arg(tree_[sibling].name)
                        : QObject::tr("It has ended: %1 comes after it and is running now").arg(tree_[sibling].name));
            else if (tree_[sibling].level <= tree_[node].level)
                say(PlanVerdict::No, sibling,
                    tree_[sibling].level == tree_[node].level
                        ? QObject::tr("%1, which has the same priority, is running now").arg(tree_[sibling].name)
                        : QObject::tr("%1 is running now and has priority over %2")
                              .arg(tree_[sibling].name, tree_[node].name));
        }
    }

    void explainSense(PlanNodeId owner, PlanNodeId sense) {
        const PlanNode& what = tree_[sense];
        const PlanActivity& state = states_[sense];
        // A goal ends its owner, so a goal that holds is a reason against running, and one that does not hold is no
        // reason.
        if (what.of_goal && state.answer && !state.answer->holds)
            return;
        const PlanVerdict verdict = !state.answer                         ? PlanVerdict::Open
                                    : state.answer->holds != what.of_goal ? PlanVerdict::Yes
                                                                          : PlanVerdict::No;
        const QString call = what.name + (what.detail.isEmpty() ? QString() : u' ' + what.detail);
        say(verdict, sense,
            what.of_goal
                ? QObject::tr("%1, goal: %2 – %3").arg(tree_[owner].name, call, answerText(state, states_.now()))
                : QObject::tr("%1: %2 – %3").arg(tree_[owner].name, call, answerText(state, states_.now())),
            state.answer ? std::optional(state.answer->since) : std::nullopt);
    }

    const PlanTree& tree_;
    const PlanStates& states_;
    std::vector<PlanReason> reasons_;
};

} // namespace

std::vector<PlanReason> planReasons(const PlanTree& tree, const PlanStates& states, PlanNodeId node) {
    return ReasonCollector(tree, states).collect(node);
}

std::vector<PlanReason> driveRefusals(const PlanTree& tree, const PlanStates& states) {
    std::vector<PlanReason> refusals;
    const auto add = [&refusals](const PlanReason& reason) {
        const auto same = [&reason](const PlanReason& one) {
            return one.node == reason.node && one.text == reason.text;
        };
        if (reason.verdict == PlanVerdict::No && std::ranges::none_of(refusals, same))
            refusals.push_back(reason);
    };
    for (const PlanNodeId node : tree.nodes())
        if (tree[node].kind == PlanNodeKind::Drive && !states[node].running)
            std::ranges::for_each(planReasons(tree, states, node), add);
    return refusals;
}

QString planVerdict(const PlanTree& tree, const PlanStates& states, PlanNodeId node) {
    const QString& name = tree[node].name;
    const PlanActivity& state = states[node];
    if (tree[node].kind == PlanNodeKind::Sense && tree[node].in_card)
        return !state.answer         ? QObject::tr("%1 has not been asked yet").arg(name)
               : state.answer->holds ? QObject::tr("%1 holds").arg(name)
                                     : QObject::tr("%1 does not hold").arg(name);
    if (state.running)
        return QObject::tr("%1 runs now").arg(name);
    const auto reasons = planReasons(tree, states, node);
    const auto refusals = std::ranges::count(reasons, PlanVerdict::No, &PlanReason::verdict);
    if (refusals > 0)
        return refusals == 1 ? QObject::tr("%1 does not run, for one reason:").arg(name)
                             : QObject::tr("%1 does not run, for %2 reasons:").arg(name).arg(refusals);
    return state.last_active ? QObject::tr("%1 does not run now; nothing refused it last").arg(name)
                             : QObject::tr("%1 has not run yet; nothing has refused it").arg(name);
}

QString answerText(const PlanActivity& state, Seconds now) {
    if (!state.answer)
        return QObject::tr("not asked yet");
    return (state.answer->holds ? QObject::tr("yes, it is %1, for %2") : QObject::tr("no, it is %1, for %2"))
        .arg(state.answer->value, ageText(now - state.answer->since));
}

QString countersText(const PlanActivity& state) {
    QStringList parts;
    const auto add = [&](std::uint64_t count, const QString& one, const QString& many) {
        if (count > 0)
            parts << (count == 1 ? one : many.arg(count));
    };
    add(state.started, QObject::tr("1 start"), QObject::tr("%1 starts"));
    add(state.succeeded, QObject::tr("1 success"), QObject::tr("%1 successes"));
    add(state.failed, QObject::tr("1 failure"), QObject::tr("%1 failures"));
    add(state.skipped, QObject::tr("held back once"), QObject::tr("held back %1 times"));
    return parts.join(QStringLiteral(", "));
}

QString lastRunText(const PlanActivity& state, Seconds now) {
    if (state.running)
        return QObject::tr("runs now");
    return state.last_active ? QObject::tr("ran %1 ago").arg(ageText(now - *state.last_active))
                             : QObject::tr("has not run yet");
}

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
