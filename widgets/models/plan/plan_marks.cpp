#include "widgets/models/plan/plan_marks.h"

#include <algorithm>

#include <QObject>

#include "core/posh/model/literal.h"

namespace usar::widgets {

namespace {

void merge(PlanMark& into, const PlanMark& from) {
    into.breakpoints += from.breakpoints;
    into.breakpoints_off += from.breakpoints_off;
    into.conditional = into.conditional || from.conditional;
    into.pinned = into.pinned || from.pinned;
    into.switched_off = into.switched_off || from.switched_off;
    into.halted = into.halted || from.halted;
    for (const QString& line : from.words)
        if (!into.words.contains(line))
            into.words << line;
}

/// The mark of that path, which is made if there is none.
PlanMark& markAt(std::vector<PlanMark>& marks, const std::string& path) {
    const auto found = std::ranges::find(marks, path, &PlanMark::path);
    return found != marks.end() ? *found : marks.emplace_back(PlanMark{.path = path});
}

} // namespace

PlanMarks::PlanMarks(const PlanTree& tree, const std::vector<PlanMark>& marks) {
    for (const PlanMark& mark : marks) {
        const PlanNodeId node = tree.find(mark.path);
        if (!node.valid())
            continue;
        merge(by_node_[node], mark);
        if (const PlanNodeId drawn = tree[node].link; drawn.valid())
            merge(by_node_[drawn], mark);
    }
}

const PlanMark* PlanMarks::at(PlanNodeId node) const {
    const auto found = by_node_.find(node);
    return found == by_node_.end() ? nullptr : &found->second;
}

void markBreakpoints(const BreakpointList& list, const std::string& plan_name, std::vector<PlanMark>& marks) {
    for (const agent::BreakpointId id : list.ofPlan(plan_name)) {
        const posh::Breakpoint& breakpoint = *list.find(id);
        if (breakpoint.path.empty() || breakpoint.on == posh::BreakOn::Written)
            continue;
        PlanMark& mark = markAt(marks, breakpoint.path);
        ++(breakpoint.enabled ? mark.breakpoints : mark.breakpoints_off);
        mark.conditional = mark.conditional || !breakpoint.condition.empty() || breakpoint.skip > 0;
        mark.words << (breakpoint.enabled ? QObject::tr("Breakpoint: %1") : QObject::tr("Breakpoint, off: %1"))
                          .arg(breakpointText(breakpoint).section(QStringLiteral(", "), 1));
    }
}

void markPins(const agent::SetPins& pins, const posh::Program& program, const std::vector<std::string>& paths,
              std::vector<PlanMark>& marks) {
    for (posh::Index place = 0; place < program.places.size() && place < paths.size(); ++place) {
        const std::string& call = posh::callTextAt(program, place);
        const bool is_act = program.places[place].kind == posh::PlaceKind::Act;
        const auto sense = std::ranges::find(pins.senses, call, &agent::SensePin::call);
        const auto act = std::ranges::find(pins.acts, call, &agent::ActPin::call);
        if (call.empty() || (is_act ? act == pins.acts.end() : sense == pins.senses.end()))
            continue;
        PlanMark& mark = markAt(marks, paths[place]);
        mark.pinned = true;
        mark.words << (is_act ? QObject::tr("Forced, so the robot does not do it: %1").arg(resultText(act->result))
                              : QObject::tr("Forced: %1").arg(QString::fromStdString(posh::spelled(sense->answer))));
    }
    for (const agent::DriveOff& off : pins.drives_off)
        if (const posh::Index place = posh::findPlace(program, off.path, off.names); place < paths.size()) {
            PlanMark& mark = markAt(marks, paths[place]);
            mark.switched_off = true;
            mark.words << QObject::tr("Switched off by the user");
        }
}

void markHalt(const std::string& path, std::vector<PlanMark>& marks) {
    PlanMark& mark = markAt(marks, path);
    mark.halted = true;
    mark.words << QObject::tr("The plan is halted here");
}

} // namespace usar::widgets
