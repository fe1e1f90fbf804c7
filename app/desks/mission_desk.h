// Desk for the task of the selected robot: behavior, area, parameters, plan and mission files, and running it.
#pragma once

#include <optional>

#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "app/desks/plugin_desk.h"
#include "app/desks/server_desk.h"
#include "core/mission/files/task_drafts.h"

namespace usar::app {

/// Keeps a draft of the task for each robot. The forms and the map show the selected robot's draft, and the user edits
/// it there. GUI thread.
class MissionDesk : public QObject {
    Q_OBJECT
public:
    MissionDesk(const DeskContext& context, PluginDesk& plugins, ServerDesk& server);

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();

    /// Reads a mission file and sets its task up for the selected robot or the next one. If the mission needs another
    /// world or a plugin that has not answered yet, this happens later. Errors are notices.
    void openMission(const QString& path);
    /// Saves the draft of the selected robot as a mission file. Errors are notices.
    void saveMission(const QString& path);
    /// Puts the plan chosen in the panel into the draft; it is used from the next start on. An empty path means the
    /// robot's own plan.
    void takePlan();
    /// Shows the behaviors again after plugins have changed, and sets up a mission that waited for one.
    void takePlugins();
    /// Removes all drawn areas, because the world they belong to is gone.
    void leaveWorld();
    /// Forgets a mission file that waits for its world.
    void forgetAwaitedWorld() { awaiting_world_.reset(); }

signals:
    /// A behavior was started on this robot, by any command.
    void begun(int id);
    /// A task was started with these faults, whose times are relative to now.
    void faultsWanted(const QStringList& faults);
    /// Another behavior was chosen, or the chosen one started or ended.
    void situationChanged();

private:
    void registerRunCommands();
    void wireArea();
    void wireRun();
    /// Shows the draft of this robot in the forms and on the map; 0: the draft of the next robot.
    void show(int robot);
    void showChosenBehavior();
    void showIsolation();
    void setArea(const Rectangle& area_in_map);
    void takeTask(const mission::SessionUpdate& update);
    /// Requests a preview of the draft, unless a behavior runs, which publishes its own path.
    void askForPreview();
    void showPreview(const Result<agent::TaskPreview>& preview);
    /// `instead` is shown in place of the preview's figures.
    void clearPreview(const QString& instead);
    void start();
    /// Starts the behavior that failed by itself on this robot again.
    void startAgain(int id);
    void offerToStartAgain(int id, const QString& key, const QString& text);
    /// Withdraws old notices and announces the start.
    void begin(int id);
    /// Id of a robot whose behavior failed by itself and was not started again, preferably the selected one; 0: none.
    int brokenRobot() const;
    void give(agent::Order order);
    void refreshRunState();
    /// Puts the form's values into the draft, and into a running behavior.
    void applyParameters(const std::map<std::string, agent::ParameterValue>& values);
    bool running() const;
    bool mayBeSaved() const;

    /// Name of the mission's world if the embedded simulator is in another one and has no robots; otherwise empty.
    QString worldToOpenFor(const mission::Mission& mission) const;
    void setUp(const mission::Mission& mission);
    /// Selects a robot of this class: the selected one, or else an idle one. If there is none, selects no robot, and
    /// the next spawned robot will be of this class.
    void selectRobotFor(const std::string& robot_class);
    /// Name of the start pose that the selected robot was spawned on, or of the first one.
    std::string startName() const;
    void chooseFile();
    void chooseWhereToSave();

    DeskContext desk_;
    PluginDesk& plugins_;
    ServerDesk& server_;
    mission::TaskDrafts drafts_;
    std::string next_class_;                          ///< class of the robot that a mission needs; empty: any
    std::optional<mission::Mission> awaiting_world_;  ///< to be set up once its world is open
    std::optional<mission::Mission> awaiting_plugin_; ///< to be set up once its plugin's process has answered
    QTimer preview_due_; ///< fires if a preview takes long; the panel then says that it was requested
};

} // namespace usar::app
