// What the selected robot is to do: behavior, area, parameters and plan, mission files, and the run itself.
#pragma once

#include <optional>

#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "app/desks/plugin_desk.h"
#include "app/desks/server_desk.h"
#include "core/mission/files/task_drafts.h"

namespace usar::app {

/// Keeps a draft of the task for each robot; the forms and the map show the selected robot's, and what is edited there
/// goes into it. GUI thread.
class MissionDesk : public QObject {
    Q_OBJECT
public:
    MissionDesk(const DeskContext& context, PluginDesk& plugins, ServerDesk& server);

    void registerCommands();
    /// Once commands are registered.
    void wire();

    void openMission(const QString& path);
    /// Saves what the selected robot is set up to do.
    void saveMission(const QString& path);
    /// The user's own plan decides from the next start on; an empty path stands for the robot's.
    void takePlan();
    /// The behavior whose plugin changed is shown again, and a mission that waited for it is set up.
    void takePlugins();
    /// The old world is gone, and with it every area that was drawn there.
    void leaveWorld();
    /// A mission file that waits for its world is forgotten.
    void forgetAwaitedWorld() { awaiting_world_.reset(); }

signals:
    /// The selected robot's behavior was started, by whichever command.
    void begun(int id);
    /// A mission's faults, whose times count from now.
    void faultsWanted(const QStringList& faults);
    /// The chosen behavior, or whether it runs, is different now.
    void situationChanged();

private:
    void registerRunCommands();
    void wireArea();
    void wireRun();
    void show(int robot);
    void showChosenBehavior();
    void showIsolation();
    void setArea(const Rectangle& area_in_map);
    void takeTask(const mission::SessionUpdate& update);
    /// Asks what the draft would come to, unless a behavior runs, which says itself what it does.
    void askForPreview();
    void showPreview(const Result<agent::TaskPreview>& preview);
    void clearPreview(const QString& instead);
    void start();
    /// Starts the behavior that broke on this robot again.
    void startAgain(int id);
    void offerToStartAgain(int id, const QString& key, const QString& text);
    void begin(int id);
    /// A robot whose behavior broke and was not started again: the selected one if it is, else any; 0: none.
    int brokenRobot() const;
    void give(agent::Order order);
    void refreshRunState();
    void applyParameters(const std::map<std::string, agent::ParameterValue>& values);
    bool running() const;
    bool mayBeSaved() const;

    /// The mission's world, if the embedded simulator is in another one with nobody in it; else empty.
    QString worldToOpenFor(const mission::Mission& mission) const;
    void setUp(const mission::Mission& mission);
    /// Selects the robot that fits: the selected one, or another one of the class that has nothing to do; else none,
    /// and the next robot that is spawned will be of that class.
    void selectRobotFor(const std::string& robot_class);
    /// Name of the start pose that the selected robot was spawned on, or of the first one.
    std::string startName() const;
    void chooseFile();
    void chooseWhereToSave();

    DeskContext desk_;
    PluginDesk& plugins_;
    ServerDesk& server_;
    mission::TaskDrafts drafts_;
    std::string next_class_;                          ///< of the robot that a mission wants; empty: any
    std::optional<mission::Mission> awaiting_world_;  ///< set up once its world is there
    std::optional<mission::Mission> awaiting_plugin_; ///< set up once its behavior's process has answered
    QTimer preview_due_; ///< fires when a preview takes long; the panel then says "asking…"
};

} // namespace usar::app
