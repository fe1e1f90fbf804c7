#include "widgets/models/plan/breakpoint_list.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QObject>

#include "core/posh/run/trace_event.h"

namespace usar::widgets {

namespace {

using agent::BreakpointId;
using posh::ActResult;
using posh::BreakOn;
using posh::Breakpoint;

constexpr std::array on_words{std::pair{BreakOn::Before, "before"},
                              std::pair{BreakOn::After, "after"},
                              std::pair{BreakOn::Result, "result"},
                              std::pair{BreakOn::VerdictChange, "verdict"},
                              std::pair{BreakOn::Interruption, "interruption"},
                              std::pair{BreakOn::Written, "written"}};

QString resultWord(ActResult result) {
    return QString::fromLatin1(posh::toText(result));
}

QJsonObject jsonOf(const Breakpoint& breakpoint) {
    const auto word = std::ranges::find(on_words, breakpoint.on, &std::pair<BreakOn, const char*>::first);
    QJsonObject json{{"path", QString::fromStdString(breakpoint.path)},
                     {"names", QString::fromStdString(breakpoint.names)},
                     {"on", word->second}};
    if (breakpoint.on == BreakOn::Result)
        json["result"] = resultWord(breakpoint.result);
    if (breakpoint.on == BreakOn::Written)
        json["key"] = QString::fromStdString(breakpoint.key);
    if (!breakpoint.condition.empty())
        json["condition"] = QString::fromStdString(breakpoint.condition);
    if (breakpoint.skip > 0)
        json["skip"] = static_cast<qint64>(breakpoint.skip);
    if (breakpoint.once)
        json["once"] = true;
    if (!breakpoint.enabled)
        json["enabled"] = false;
    return json;
}

/// Returns nullopt if the object is not a valid breakpoint.
std::optional<Breakpoint> breakpointOf(const QJsonObject& json) {
    Breakpoint breakpoint;
    breakpoint.path = json["path"].toString().toStdString();
    breakpoint.names = json["names"].toString().toStdString();
    const QString on = json["on"].toString();
    const auto word = std::ranges::find_if(on_words, [&](const auto& one) { return on == QLatin1String(one.second); });
    if (word == on_words.end() || breakpoint.names.empty())
        return std::nullopt;
    breakpoint.on = word->first;
    breakpoint.key = json["key"].toString().toStdString();
    if (breakpoint.on == BreakOn::Written && breakpoint.key.empty())
        return std::nullopt;
    for (const ActResult result : {ActResult::Finished, ActResult::RunningOnce, ActResult::Running, ActResult::Failed})
        if (json["result"].toString() == resultWord(result))
            breakpoint.result = result;
    breakpoint.condition = json["condition"].toString().toStdString();
    if (!posh::Breakpoints::checkCondition(breakpoint.condition))
        return std::nullopt;
    breakpoint.skip = static_cast<std::uint64_t>(std::max<qint64>(0, json["skip"].toInteger()));
    breakpoint.once = json["once"].toBool();
    breakpoint.enabled = json["enabled"].toBool(true);
    return breakpoint;
}

bool isOfPlan(const Breakpoint& breakpoint, std::string_view name) {
    const std::string_view names = breakpoint.names;
    return names.starts_with(name) && (names.size() == name.size() || names.substr(name.size()).starts_with(" ▸ "));
}

/// Returns the ids of the breakpoints of a plan for which `fits` is true.
template <class Fits>
std::vector<BreakpointId> idsOf(const std::vector<agent::PlanBreakpoint>& all, std::string_view plan_name, Fits fits) {
    std::vector<BreakpointId> ids;
    for (const auto& [id, what] : all)
        if (isOfPlan(what, plan_name) && fits(what))
            ids.push_back(id);
    return ids;
}

} // namespace

const Breakpoint* BreakpointList::find(BreakpointId id) const {
    const auto found = std::ranges::find(all_, id, &agent::PlanBreakpoint::id);
    return found == all_.end() ? nullptr : &found->what;
}

BreakpointId BreakpointList::add(Breakpoint breakpoint) {
    all_.push_back({{next_id_++}, std::move(breakpoint)});
    return all_.back().id;
}

void BreakpointList::change(BreakpointId id, Breakpoint breakpoint) {
    if (const auto found = std::ranges::find(all_, id, &agent::PlanBreakpoint::id); found != all_.end())
        found->what = std::move(breakpoint);
}

void BreakpointList::remove(const std::vector<BreakpointId>& ids) {
    for (const BreakpointId id : ids)
        remove(id);
}

void BreakpointList::toggle(std::string_view plan_name, const std::vector<PlanSpot>& spots, BreakOn on) {
    const std::vector<BreakpointId> known = atSpots(plan_name, spots, on);
    remove(known);
    if (known.empty())
        for (const PlanSpot& spot : spots)
            add({.path = spot.path, .names = spot.names, .on = on, .condition = {}});
}

void BreakpointList::toggleKey(const posh::Program& program, const std::string& key) {
    const std::vector<BreakpointId> known = ofKey(program.title, key);
    remove(known);
    if (known.empty())
        add({.path = posh::pathOf(program, 0),
             .names = posh::namePathOf(program, 0),
             .on = BreakOn::Written,
             .key = key,
             .condition = {}});
}

void BreakpointList::enable(BreakpointId id, bool on) {
    if (const auto found = std::ranges::find(all_, id, &agent::PlanBreakpoint::id); found != all_.end())
        found->what.enabled = on;
}

void BreakpointList::toggleEnabled(const std::vector<BreakpointId>& ids) {
    const bool any_on = std::ranges::any_of(ids, [this](BreakpointId id) { return find(id) && find(id)->enabled; });
    for (const BreakpointId id : ids)
        enable(id, !any_on);
}

std::vector<BreakpointId> BreakpointList::ofPlan(std::string_view name) const {
    return idsOf(all_, name, [](const Breakpoint&) { return true; });
}

std::vector<BreakpointRow> BreakpointList::rowsOfPlan(std::string_view name) const {
    std::vector<BreakpointRow> rows;
    for (const BreakpointId id : ofPlan(name)) {
        const Breakpoint& what = *find(id);
        const QString lost = what.path.empty() ? QObject::tr("\nThe plan has no such place now.") : QString();
        rows.push_back({id, breakpointText(what), QString::fromStdString(what.names) + lost, what.path, what.enabled});
    }
    return rows;
}

QStringList BreakpointList::keysOfPlan(std::string_view name) const {
    QStringList keys;
    for (const BreakpointId id : ofPlan(name))
        if (find(id)->on == BreakOn::Written)
            keys << QString::fromStdString(find(id)->key);
    return keys;
}

std::vector<BreakpointId> BreakpointList::ofKey(std::string_view plan_name, std::string_view key) const {
    return idsOf(all_, plan_name,
                 [key](const Breakpoint& what) { return what.on == BreakOn::Written && what.key == key; });
}

std::vector<BreakpointId> BreakpointList::atPath(std::string_view plan_name, std::string_view path) const {
    return idsOf(all_, plan_name,
                 [path](const Breakpoint& what) { return what.on != BreakOn::Written && what.path == path; });
}

std::vector<BreakpointId> BreakpointList::atSpots(std::string_view plan_name, const std::vector<PlanSpot>& spots,
                                                  std::optional<BreakOn> on) const {
    std::vector<BreakpointId> ids;
    for (const PlanSpot& spot : spots)
        for (const BreakpointId id : atPath(plan_name, spot.path))
            if (!on || find(id)->on == *on)
                ids.push_back(id);
    return ids;
}

void BreakpointList::repairPaths(const posh::Program& program) {
    for (auto& [id, what] : all_) {
        if (!isOfPlan(what, program.title))
            continue;
        const posh::Index place = posh::findPlace(program, what.path, what.names);
        what.path = place == posh::nowhere ? std::string() : posh::pathOf(program, place);
    }
}

void BreakpointList::setTemporary(const std::vector<PlanSpot>& spots) {
    dropTemporary();
    for (const PlanSpot& spot : spots)
        temporary_.push_back(
            add({.path = spot.path, .names = spot.names, .on = BreakOn::Before, .condition = {}, .once = true}));
}

bool BreakpointList::dropTemporary() {
    const std::vector<BreakpointId> dropped = std::exchange(temporary_, {});
    remove(dropped);
    return !dropped.empty();
}

void BreakpointList::takeHit(BreakpointId id) {
    if (const Breakpoint* const known = find(id); known && known->once)
        enable(id, false);
}

QByteArray BreakpointList::toJson() const {
    QJsonArray list;
    for (const auto& [id, what] : all_)
        if (!std::ranges::count(temporary_, id))
            list.append(jsonOf(what));
    return QJsonDocument(list).toJson(QJsonDocument::Compact);
}

BreakpointList BreakpointList::fromJson(const QByteArray& json) {
    BreakpointList list;
    for (const QJsonValue& one : QJsonDocument::fromJson(json).array())
        if (auto breakpoint = breakpointOf(one.toObject()))
            list.add(*std::move(breakpoint));
    return list;
}

QString resultText(ActResult result) {
    constexpr std::array words{"finished at once", "finished", "still running", "failed"}; // In their order.
    return QObject::tr(words[static_cast<std::size_t>(result)]);
}

QString breakOnText(const Breakpoint& breakpoint) {
    if (breakpoint.on == BreakOn::Result)
        return QObject::tr("when it answers: %1").arg(resultText(breakpoint.result));
    if (breakpoint.on == BreakOn::Written)
        return QObject::tr("when %1 is written").arg(QString::fromStdString(breakpoint.key));
    return breakpoint.on == BreakOn::Before          ? QObject::tr("before")
           : breakpoint.on == BreakOn::After         ? QObject::tr("after")
           : breakpoint.on == BreakOn::VerdictChange ? QObject::tr("when its verdict changes")
                                                     : QObject::tr("when it is interrupted");
}

QString breakpointText(const Breakpoint& breakpoint) {
    QStringList parts{QString::fromStdString(breakpoint.names).section(QStringLiteral(" ▸ "), -1),
                      breakOnText(breakpoint)};
    if (!breakpoint.condition.empty())
        parts << QObject::tr("if %1").arg(QString::fromStdString(breakpoint.condition));
    if (breakpoint.skip > 0)
        parts << QObject::tr("from hit %1 on").arg(breakpoint.skip + 1);
    if (breakpoint.once)
        parts << QObject::tr("once");
    return parts.join(QStringLiteral(", "));
}

} // namespace usar::widgets
