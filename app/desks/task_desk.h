// The selected robot's task (behavior, area, parameters and plan) and its run.
#pragma once

#include <QTimer>

#include "app/desks/desk.h"
#include "app/desks/plugin_desk.h"
#include "core/mission/edits/task_edits.h"
#include "core/mission/files/last_area.h"

namespace usar::app {

/// Keeps a draft of the task for each robot. The forms and the map show the selected robot's draft, and edits there
/// change it. Starts, pauses and stops the behavior of the draft. Belongs to the GUI thread.
class TaskDesk : public Desk {
    Q_OBJECT
public:
    TaskDesk(const DeskContext& context, PluginDesk& plugins);

    void registerCommands() override;
    void wire() override;
    /// Keeps the area that is drawn in a world, for the next start in the same world.
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

    /// The draft of the robot that is selected.
    const mission::TaskDraft& draft() const { return drafts_.shown(); }
    /// True if a behavior is chosen, and an area if it needs one.
    bool complete() const;
    /// True if the chosen behavior is to run in a separate process.
    bool isolated() const { return plugins_.isolates(plugins_.pluginOf(drafts_.shown().behavior_id)); }
    /// Offers behaviors for this class while no robot is selected; empty: for any class.
    void preferClass(const std::string& robot_class) { wanted_class_ = robot_class; }
    /// Takes over what a mission file says. `values`: its parameters in SI units and radians.
    void setUp(const mission::Mission& mission, const std::map<std::string, agent::ParameterValue>& values);
    /// The robots that commands apply to, in words: "R1", "R1, R2 and R3", "7 robots". Empty without a robot.
    QString addressees() const;
    /// Uses the user's plan from the next start on; an empty path means the robot's own.
    void takePlan();
    /// A behavior was started on this robot by somebody else; it is shown like one that was started here.
    void takeBegun(RobotId id);
    /// Clears every drawn area, because the world that they were drawn in is gone.
    void leaveWorld();

signals:
    /// The selected robot's behavior was started, by whichever command.
    void begun(usar::RobotId id);
    /// A mission's faults are to be injected; their times count from now.
    void faultsWanted(const QStringList& faults);
    /// Another behavior was chosen, or the behavior has started or ended.
    void situationChanged();

private:
    void wireArea();
    /// Draws the area of the last time if this is its world and nothing is drawn yet.
    void bringBackArea(const QString& world);
    /// Shows the draft of this robot in the forms and on the map; 0: that without a robot.
    void show(RobotId robot);
    void showChosenBehavior();
    /// Shows what undo or redo has changed, and selects the robot if it is another.
    void showEdited(RobotId robot);
    void showIsolation() { views_.behavior->setIsolated(isolated()); }
    /// Returns the start pose with this name, in the map frame; nullopt if this world has none.
    std::optional<Vec2> placeOfStart(const std::string& name) const;
    /// Stores the drawn area in the draft as an edit; an empty rectangle removes it.
    void setArea(const Rectangle& area_in_map);
    void takeTask(const mission::SessionUpdate& update);
    /// Requests a preview of the draft, unless a behavior runs, which reports its task itself.
    void askForPreview();
    void showPreview(const Result<agent::TaskPreview>& preview);
    void clearPreview(const QString& instead);
    /// The selected robot and those that are marked with it in the list.
    std::vector<Robot*> chosen() const;
    /// Those of them whose behavior runs.
    std::vector<Robot*> chosenAtWork() const;
    /// True if the robot stands ready and a behavior is set up for it.
    bool mayStart(const Robot& robot);
    /// Starts on each chosen robot that may start what is set up for it; an error is a notice.
    void start();
    /// Returns true if it was started.
    bool startOne(Robot& robot);
    /// Shows that the selected robot's behavior was started from its draft.
    void showStarted();
    /// Starts the behavior that broke on this robot again.
    void startAgain(RobotId id);
    void offerToStartAgain(RobotId id, const QString& key, const QString& text);
    void begin(RobotId id);
    /// Id of a robot whose behavior broke and was not started again, preferably the selected robot; 0: none.
    RobotId brokenRobot() const;
    /// Gives an order to the behaviors of the chosen robots.
    void give(agent::Order order);
    /// Pauses the chosen robots if one of them works on; otherwise all of them continue.
    void pauseOrResume();
    void refreshRunState();
    void applyParameters(std::map<std::string, agent::ParameterValue> values); ///< may be those of the draft
    /// True if a behavior runs on the selected robot.
    bool running() const { return robot() && robot()->running(); }

    PluginDesk& plugins_;
    mission::TaskDrafts drafts_;
    mission::TaskEdits edits_{control_.history(), drafts_, [this](RobotId robot) { showEdited(robot); }};
    bool showing_ = false;        ///< the forms are being filled, so what they report is no edit
    std::string wanted_class_;    ///< robot class that the mission needs; empty: any
    mission::LastArea last_area_; ///< as it was drawn when the program ran last
    QTimer preview_due_;          ///< fires when a preview takes long; the panel then says "asking…"
};

} // namespace usar::app
