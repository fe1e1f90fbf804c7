#include "app/desks/plan_desk.h"

#include <algorithm>
#include <utility>

#include "core/mission/fleet/robot_name.h"
#include "core/posh/model/literal.h"
#include "widgets/models/figures.h"
#include "widgets/plan/breakpoint_dialog.h"
#include "widgets/plan/pin_dialog.h"

namespace usar::app {

using agent::PlanFate;
using posh::PlaceKind;
using widgets::PlanMark;
using News = PlanWatch::News;

namespace {

/// Returns the mark with this path; adds one if there is none.
PlanMark& markAt(std::vector<PlanMark>& marks, const std::string& path) {
    const auto found = std::ranges::find(marks, path, &PlanMark::path);
    return found != marks.end() ? *found : marks.emplace_back(PlanMark{.path = path});
}

void markPins(const agent::SetPins& pins, const posh::Program& program, const std::vector<std::string>& paths,
              std::vector<PlanMark>& marks) {
    for (posh::Index place = 0; place < program.places.size() && place < paths.size(); ++place) {
        const std::string& call = posh::callTextAt(program, place);
        const bool is_act = program.places[place].kind == PlaceKind::Act;
        const auto sense = std::ranges::find(pins.senses, call, &agent::SensePin::call);
        const auto act = std::ranges::find(pins.acts, call, &agent::ActPin::call);
        if (call.empty() || (is_act ? act == pins.acts.end() : sense == pins.senses.end()))
            continue;
        PlanMark& mark = markAt(marks, paths[place]);
        mark.pinned = true;
        mark.words << (is_act
                           ? QObject::tr("Pinned, the robot does not do it: %1").arg(widgets::resultText(act->result))
                           : QObject::tr("Pinned: %1").arg(QString::fromStdString(posh::spelled(sense->answer))));
    }
    for (const agent::DriveOff& off : pins.drives_off)
        if (const posh::Index place = posh::findPlace(program, off.path, off.names); place < paths.size()) {
            PlanMark& mark = markAt(marks, paths[place]);
            mark.switched_off = true;
            mark.words << QObject::tr("Switched off by hand");
        }
}

} // namespace

PlanDesk::PlanDesk(const DeskContext& context)
    : control_(context.control)
    , views_(context.views)
    , commands_(context.commands)
    , selection_(context.selection)
    , notices_(context.notices)
    , window_(context.window) {}

void PlanDesk::restore(const QSettings& settings) {
    list_ = widgets::BreakpointList::fromJson(settings.value("plan/breakpoints").toByteArray());
    breakpointsChanged();
}

void PlanDesk::save(QSettings& settings) const {
    widgets::BreakpointList lasting = list_;
    for (const int id : temporary_)
        lasting.remove(id);
    settings.setValue("plan/breakpoints", lasting.toJson());
}

PlanWatch& PlanDesk::watch() {
    return watches_[control_.connectionOf(selected_)];
}

void PlanDesk::welcome(int id) {
    if (Robot* robot = control_.robot(id); robot && !robot->isReplay())
        robot->control(agent::SetBreakpoints{list_.all()});
}

void PlanDesk::begin(int id) {
    pins_.erase(control_.connectionOf(id));
    if (id == selected_)
        showMarks();
}

void PlanDesk::take(int id, const mission::SessionUpdate& update) {
    const Robot* const robot = control_.robot(id);
    if (!robot)
        return;
    const News news = watches_[robot->view().connection].take(update);
    if (!robot->isReplay())
        for (const agent::Published& published : update.published)
            std::visit([&](const auto& value) { takeNews(id, value); }, published);
    if (id != selected_)
        return;
    show(news);
    showLookBack();
}

void PlanDesk::select(int id) {
    selected_ = id;
    epoch_wanted_ = false;
    views_.plan->clear();
    if (control_.robot(id))
        show(News::Plan);
    showHalt();
    showTime();
    showMarks();
    showLookBack();
}

void PlanDesk::show(News news) {
    const PlanWatch& shown = watch();
    if (news == News::Plan) {
        if (shown.empty()) {
            views_.plan->clear();
        } else {
            views_.plan->setPlan(shown.plan());
            views_.plan->setPlanText(shown.planText(), shown.findings());
            list_.repairPaths(*shown.program());
        }
        showMarks();
        emit planShown(shown.planText());
    }
    if (news == News::None)
        return;
    if (!shown.empty())
        views_.plan->setSnapshot(shown.snapshot());
    showTime();
}

void PlanDesk::showTime() {
    const bool was_live = views_.plan->timeBar().time().live;
    views_.plan->timeBar().setTime(watch().time());
    if (was_live != watch().live())
        commands_.refresh();
}

void PlanDesk::showHalt() {
    const Robot* const shown = robot();
    const bool stands = shown && shown->running() && shown->view().halted;
    if (!stands)
        return views_.plan->haltBar().setText({});
    const agent::PlanHalted& halted = *shown->view().halted;
    QString text = tr("%1 stands still: %2 · cycle %3, %4 s")
                       .arg(nameOf(*shown), QString::fromStdString(halted.reason))
                       .arg(halted.cycle)
                       .arg(widgets::figure(halted.time.count(), 1));
    if (!shown->view().figures.lockstep)
        text += tr(". The robot has its safe command; the server's time goes on.");
    views_.plan->haltBar().setText(text);
}

void PlanDesk::showMarks() {
    const PlanWatch& shown = watch();
    std::vector<PlanMark> marks;
    if (shown.program()) {
        for (const int id : list_.ofPlan(shown.program()->title)) {
            const posh::Breakpoint& breakpoint = *list_.find(id);
            if (breakpoint.path.empty() || breakpoint.on == posh::BreakOn::Written)
                continue;
            PlanMark& mark = markAt(marks, breakpoint.path);
            ++(breakpoint.enabled ? mark.breakpoints : mark.breakpoints_off);
            mark.conditional = mark.conditional || !breakpoint.condition.empty() || breakpoint.skip > 0;
            mark.words << (breakpoint.enabled ? tr("Breakpoint: %1") : tr("Breakpoint, off: %1"))
                              .arg(widgets::breakpointText(breakpoint).section(QStringLiteral(", "), 1));
        }
        if (const auto pins = pins_.find(control_.connectionOf(selected_)); pins != pins_.end())
            markPins(pins->second, *shown.program(), shown.paths(), marks);
        const Robot* const flown = robot();
        if (flown && flown->running() && flown->view().halted && !flown->view().halted->path.empty()) {
            PlanMark& mark = markAt(marks, flown->view().halted->path);
            mark.halted = true;
            mark.words << tr("The plan stands still here");
        }
    }
    views_.plan->view().setMarks(std::move(marks));
    showBreakpoints();
    commands_.refresh();
}

void PlanDesk::showBreakpoints() {
    std::vector<widgets::BreakpointRow> rows;
    QStringList keys;
    if (const auto& program = watch().program())
        for (const int id : list_.ofPlan(program->title)) {
            const posh::Breakpoint& breakpoint = *list_.find(id);
            QString help = QString::fromStdString(breakpoint.names);
            if (breakpoint.on == posh::BreakOn::Written)
                keys << QString::fromStdString(breakpoint.key);
            if (breakpoint.path.empty())
                help += tr("\nThe plan has no such place now.");
            rows.push_back({id, widgets::breakpointText(breakpoint), help, breakpoint.path, breakpoint.enabled});
        }
    views_.plan->setBreakpoints(rows);
    views_.plan->setWatchedKeys(keys);
}

bool PlanDesk::anyHalted() const {
    return std::ranges::any_of(control_.robots(),
                               [](const Robot* robot) { return robot->running() && robot->view().halted; });
}

void PlanDesk::takeNews(int id, const agent::PlanHalted& halted) {
    const Robot& robot = *control_.robot(id);
    if (const auto* const breakpoint = halted.breakpoint ? list_.find(*halted.breakpoint) : nullptr;
        breakpoint && breakpoint->once && !std::ranges::count(temporary_, *halted.breakpoint)) {
        posh::Breakpoint over = *breakpoint;
        over.enabled = false;
        list_.change(*halted.breakpoint, over);
    }
    dropTemporary();
    stepping_ = false;
    if (halted.breakpoint)
        views_.notifications->push("plan-halted/" + nameOf(robot), Severity::Note,
                                   tr("%1 stands still: %2.").arg(nameOf(robot), QString::fromStdString(halted.reason)),
                                   id != selected_);
    emit timeWanted(false);
    if (id != selected_)
        return;
    const News first_epoch = std::exchange(epoch_wanted_, false) ? watch().goToFirstEpoch() : News::None;
    show(first_epoch == News::None ? watch().goLive() : first_epoch);
    showHalt();
    showMarks();
    if (!halted.path.empty())
        views_.plan->view().selectPath(halted.path);
}

void PlanDesk::takeNews(int id, const agent::PlanResumed&) {
    views_.notifications->cured("plan-halted/" + nameOf(*control_.robot(id)));
    if (!anyHalted() && !stepping_)
        emit timeWanted(true);
    if (id != selected_ || stepping_) // While stepping it will be halted again in a moment.
        return;
    showHalt();
    showMarks();
}

void PlanDesk::takeNews(int id, const agent::PlanReplaced& replaced) {
    const QString who = nameOf(*control_.robot(id));
    const QString plan = QString::fromStdString(replaced.plan_name);
    const QString key = "plan-replaced/" + who;
    if (replaced.fate == PlanFate::Kept)
        return views_.notifications->push(key, Severity::Note, tr("%1 goes on where it was, by %2.").arg(who, plan),
                                          true);
    if (replaced.fate == PlanFate::Restarted)
        return views_.notifications->push(key, Severity::Note, tr("%1 begins %2 at its root.").arg(who, plan), true);
    QString why = QString::fromStdString(replaced.reason);
    for (const posh::Finding& finding : replaced.findings)
        if (why.isEmpty() && posh::severityOf(finding.code) == Severity::Error)
            why = QString::fromStdString(posh::toText(finding));
    views_.notifications->push(key, Severity::Error,
                               tr("%1 does not take %2 and goes on as it did. %3").arg(who, plan, why), true);
}

std::vector<PlanDesk::PlanSpot> PlanDesk::selectedSpots() {
    const widgets::PlanView& view = views_.plan->view();
    const auto& program = watch().program();
    std::vector<PlanSpot> spots;
    if (view.selected() < 0 || !program)
        return spots;
    const std::vector<std::string>& paths = watch().paths();
    for (posh::Index place = 0; place < paths.size(); ++place) {
        const int node = view.tree().find(paths[place]);
        if (node == view.selected() || (node >= 0 && view.tree()[node].link == view.selected()))
            spots.push_back({paths[place], posh::namePathOf(*program, place), posh::callTextAt(*program, place),
                             program->places[place].kind});
    }
    return spots;
}

std::vector<int> PlanDesk::breakpointsSelected(std::optional<posh::BreakOn> on) {
    std::vector<int> ids;
    for (const PlanSpot& spot : selectedSpots())
        for (const int id : list_.atPath(watch().program()->title, spot.path))
            if (!on || list_.find(id)->on == *on)
                ids.push_back(id);
    return ids;
}

void PlanDesk::breakpointsChanged() {
    for (Robot* robot : control_.robots())
        if (!robot->isReplay())
            robot->control(agent::SetBreakpoints{list_.all()});
    showMarks();
}

void PlanDesk::toggleBreakpoint(posh::BreakOn on) {
    const std::vector<int> known = breakpointsSelected(on);
    for (const int id : known)
        list_.remove(id);
    if (known.empty())
        for (const PlanSpot& spot : selectedSpots())
            list_.add({.path = spot.path, .names = spot.names, .on = on, .condition = {}});
    breakpointsChanged();
}

void PlanDesk::toggleKeyBreakpoint() {
    const std::string key = views_.plan->selectedKey().toStdString();
    const auto& program = watch().program();
    if (key.empty() || !program)
        return;
    const std::vector<int> known = list_.ofKey(program->title, key);
    for (const int id : known)
        list_.remove(id);
    if (known.empty())
        list_.add({.path = posh::pathOf(*program, 0),
                   .names = posh::namePathOf(*program, 0),
                   .on = posh::BreakOn::Written,
                   .key = key,
                   .condition = {}});
    breakpointsChanged();
}

void PlanDesk::switchBreakpoint(int id, bool on) {
    const posh::Breakpoint* const known = list_.find(id);
    if (!known)
        return;
    posh::Breakpoint changed = *known;
    changed.enabled = on;
    list_.change(id, changed);
    breakpointsChanged();
}

void PlanDesk::switchSelected() {
    const std::vector<int> ids = breakpointsSelected();
    const bool any_on = std::ranges::any_of(ids, [this](int id) { return list_.find(id)->enabled; });
    for (const int id : ids)
        switchBreakpoint(id, !any_on);
}

void PlanDesk::editBreakpoint(int id) {
    const posh::Breakpoint* const known = list_.find(id);
    if (!known)
        return;
    auto* const dialog = new widgets::BreakpointDialog(*known, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, id, dialog] {
        list_.change(id, dialog->breakpoint());
        breakpointsChanged();
    });
    dialog->open();
}

/// Edits the first breakpoint at the selected card; sets one if there is none.
void PlanDesk::editSelected() {
    if (breakpointsSelected().empty())
        toggleBreakpoint(posh::BreakOn::Before);
    if (const std::vector<int> ids = breakpointsSelected(); !ids.empty())
        editBreakpoint(ids.front());
}

void PlanDesk::runToSelected() {
    dropTemporary();
    for (const PlanSpot& spot : selectedSpots())
        temporary_.push_back(list_.add(
            {.path = spot.path, .names = spot.names, .on = posh::BreakOn::Before, .condition = {}, .once = true}));
    breakpointsChanged();
    goOn();
}

void PlanDesk::dropTemporary() {
    if (temporary_.empty())
        return;
    for (const int id : std::exchange(temporary_, {}))
        list_.remove(id);
    breakpointsChanged();
}

/// Robots in lockstep step together, because their server's time waits for all of them.
void PlanDesk::stepCycle() {
    stepping_ = true;
    for (Robot* each : control_.robots())
        if (each->running() && each->view().halted && (each == robot() || each->view().figures.lockstep))
            each->control(agent::PlanStep::Cycle);
    emit cycleWanted();
}

void PlanDesk::goOn() {
    epoch_wanted_ = stepping_ = false;
    for (Robot* each : control_.robots())
        if (each->running() && each->view().halted)
            each->control(agent::PlanStep::Continue);
}

void PlanDesk::stepEpoch() {
    if (const News news = watch().stepEpoch(); news != News::None)
        return show(news);
    stepCycle();
    epoch_wanted_ = true;
}

void PlanDesk::pinsChanged() {
    if (Robot* const pinned = robot())
        pinned->control(pins_[pinned->view().connection]);
    showMarks();
}

void PlanDesk::pinSelected() {
    const std::vector<PlanSpot> spots = selectedSpots();
    if (spots.empty() || spots.front().call.empty() || !robot())
        return;
    const std::string call = spots.front().call;
    const int connection = robot()->view().connection;
    agent::SetPins& pins = pins_[connection];
    const bool is_act = spots.front().kind == PlaceKind::Act;
    const auto released = is_act ? std::erase_if(pins.acts, [&](const auto& pin) { return pin.call == call; })
                                 : std::erase_if(pins.senses, [&](const auto& pin) { return pin.call == call; });
    if (released > 0)
        return pinsChanged();
    const auto& answer = views_.plan->view().states()[views_.plan->view().selected()].answer;
    const QString shown = QString::fromStdString(call);
    auto* const dialog = is_act ? widgets::PinDialog::forAct(shown, window_)
                                : widgets::PinDialog::forSense(shown, answer ? answer->value : QString(), window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, is_act, call, connection] {
        if (is_act)
            pins_[connection].acts.push_back({call, dialog->result()});
        else if (const auto value = dialog->answer())
            pins_[connection].senses.push_back({call, *value});
        pinsChanged();
    });
    dialog->open();
}

void PlanDesk::toggleDrive() {
    const std::vector<PlanSpot> spots = selectedSpots();
    if (spots.empty() || !robot())
        return;
    auto& off = pins_[robot()->view().connection].drives_off;
    const agent::DriveOff drive{spots.front().path, spots.front().names};
    if (std::erase(off, drive) == 0)
        off.push_back(drive);
    pinsChanged();
}

} // namespace usar::app
