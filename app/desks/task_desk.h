// What the selected robot is to do: behavior, area, parameters and plan, and the run itself.
#pragma once

#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "app/desks/plugin_desk.h"
#include "core/mission/files/task_drafts.h"

namespace usar::app {

/// Keeps a draft of the task for each robot; the forms and the map show the selected robot's, and what is edited there
/// goes into it. Starts, pauses and stops what the draft says. GUI thread.
class TaskDesk : public QObject {
    Q_OBJECT
public:
    TaskDesk(const DeskContext& context, PluginDesk& plugins);

    void registerCommands();
    /// Once commands are registered.
    void wire();

    /// The draft of the robot that is selected.
    const mission::TaskDraft& draft() const { return drafts_.shown(); }
    /// A behavior is chosen, and an area if it needs one.
    bool complete() const;
    /// The chosen behavior runs in a process of its own.
    bool isolated() const;
    /// While no robot is selected, behaviors for this class are offered; empty: for any.
    void preferClass(const std::string& robot_class) { wanted_class_ = robot_class; }
    /// Takes over what a mission file says. `values`: its parameters in SI units and radians.
    void setUp(const mission::Mission& mission, const std::map<std::string, agent::ParameterValue>& values);
    /// The user's own plan decides from the next start on; an empty path stands for the robot's.
    void takePlan();
    /// The old world is gone, and with it every area that was drawn there.
    void leaveWorld();

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

    DeskContext desk_;
    PluginDesk& plugins_;
    mission::TaskDrafts drafts_;
    std::string wanted_class_; ///< of the robot that a mission wants; empty: any
    QTimer preview_due_;       ///< fires when a preview takes long; the panel then says "asking…"
};

} // namespace usar::app
