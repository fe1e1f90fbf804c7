#include "core/mission/edits/task_edits.h"

#include <algorithm>
#include <utility>

namespace usar::mission {

namespace {

QString areaText(const std::optional<Rectangle>& before, const std::optional<Rectangle>& after) {
    if (!before)
        return EditHistory::tr("draw area");
    if (!after)
        return EditHistory::tr("remove area");
    const Vec2 change_m = (after->max_m - after->min_m) - (before->max_m - before->min_m);
    constexpr double rounding_m = 1e-6;
    return change_m.norm() < rounding_m ? EditHistory::tr("move area") : EditHistory::tr("resize area");
}

/// The ids of the parameters whose values differ.
std::vector<std::string> changedIn(const std::map<std::string, agent::ParameterValue>& before,
                                   const std::map<std::string, agent::ParameterValue>& after) {
    std::vector<std::string> ids;
    for (const auto& [id, value] : after)
        if (const auto old = before.find(id); old == before.end() || old->second != value)
            ids.push_back(id);
    return ids;
}

} // namespace

template <class T>
void TaskEdits::record(const QString& part, const QString& text, T TaskDraft::*member, const T& before) {
    const RobotId robot = drafts_.shownRobot();
    history_.add(valueEdit<T>(subjectOf(robot) + part, text, before, drafts_.shown().*member,
                              [this, robot, member](const T& value) {
                                  drafts_.of(robot).*member = value;
                                  show_(robot);
                              }));
}

void TaskEdits::setArea(const Rectangle& area_in_map) {
    auto& area = drafts_.shown().area_in_map;
    const auto before = std::exchange(area, area_in_map.empty() ? std::nullopt : std::optional(area_in_map));
    record(QStringLiteral("area"), areaText(before, area), &TaskDraft::area_in_map, before);
}

void TaskEdits::setValues(std::map<std::string, agent::ParameterValue> values,
                          const std::vector<agent::ParameterSpec>& specs) {
    const auto before = std::exchange(drafts_.shown().values, values);
    const std::vector<std::string> ids = changedIn(before, values);
    const auto spec = ids.size() == 1 ? std::ranges::find(specs, ids.front(), &agent::ParameterSpec::id) : specs.end();
    if (spec == specs.end())
        return record(QStringLiteral("parameters"), EditHistory::tr("set parameters"), &TaskDraft::values, before);
    record(QStringLiteral("parameter ") + QString::fromStdString(spec->id),
           EditHistory::tr("set %1").arg(QString::fromStdString(spec->label)), &TaskDraft::values, before);
}

void TaskEdits::replaced(const TaskDraft& before, const QString& text) {
    const RobotId robot = drafts_.shownRobot();
    Edit edit = valueEdit<TaskDraft>(subjectOf(robot) + QStringLiteral("all"), text, before, drafts_.shown(),
                                     [this, robot](const TaskDraft& draft) {
                                         drafts_.of(robot) = draft;
                                         show_(robot);
                                     });
    history_.endStep(); // Each mission and each choice is a step of its own.
    history_.add(std::move(edit));
    history_.endStep();
}

void TaskEdits::forget(RobotId robot) {
    history_.lock([robot](const QString& subject) { return subject.startsWith(subjectOf(robot)); },
                  EditHistory::tr("the robot is gone"));
}

void TaskEdits::forgetAreas() {
    const auto has_area = [](const QString& subject) {
        return subject.startsWith("task ") && (subject.endsWith("/area") || subject.endsWith("/all"));
    };
    history_.lock(has_area, EditHistory::tr("it belongs to the world that was left"));
}

} // namespace usar::mission
