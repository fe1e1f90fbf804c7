// Edits of the tasks that the user sets up, with their steps in the history.
#pragma once

#include <vector>

#include "core/mission/edits/edit_history.h"
#include "core/mission/files/task_drafts.h"

namespace usar::mission {

/// Changes the draft of the shown robot and records each change. Undo changes the draft of the robot that was edited,
/// whichever is shown then. Belongs to the thread of the drafts.
class TaskEdits {
public:
    /// Called after undo or redo has changed this robot's draft, so that its views show it.
    using Show = std::function<void(RobotId robot)>;

    /// Both must outlive this object, and so must whatever `show` refers to.
    TaskEdits(EditHistory& history, TaskDrafts& drafts, Show show)
        : history_(history)
        , drafts_(drafts)
        , show_(std::move(show)) {}

    /// Stores the area in the draft, in meters of the map frame; an empty rectangle removes it. A drag is one step
    /// until `EditHistory::endStep`.
    void setArea(const Rectangle& area_in_map);
    /// Stores values, in SI units and radians; those of the draft itself may be passed. Consecutive edits of one
    /// parameter are one step, named after it.
    void setValues(std::map<std::string, agent::ParameterValue> values, const std::vector<agent::ParameterSpec>& specs);
    /// Records that the shown draft was `before`: a mission was opened, or another behavior or plan was chosen. `text`
    /// stands after "Undo".
    void replaced(const TaskDraft& before, const QString& text);
    /// The robot is gone: its edits stay in the history, but nothing can be undone there.
    void forget(RobotId robot);
    /// The world is gone, and with it all areas.
    void forgetAreas();

    /// The beginning of the subjects of this robot's edits: "task 1/".
    static QString subjectOf(RobotId robot) { return QStringLiteral("task %1/").arg(robot.value); }

private:
    /// Records that a part of the shown draft has changed.
    template <class T>
    void record(const QString& part, const QString& text, T TaskDraft::*member, const T& before);

    EditHistory& history_;
    TaskDrafts& drafts_;
    Show show_;
};

} // namespace usar::mission
