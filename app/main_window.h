// The window: views in docks, commands in one registry, and the wires between them and MissionControl.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include <QMainWindow>
#include <QSettings>
#include <QThreadPool>
#include <QTimer>

#include "app/camera_desk.h"
#include "app/drive_desk.h"
#include "app/mission_control.h"
#include "app/options.h"
#include "app/plan_desk.h"
#include "app/plan_workshop.h"
#include "app/plugin_watch.h"
#include "app/radio_presenter.h"
#include "app/robot_presenter.h"
#include "app/window_views.h"
#include "app/world_editor.h"
#include "core/mission/mission_file.h"
#include "widgets/command_registry.h"

namespace usar::app {

/// What a person has set up for a robot and may not have started yet.
struct TaskDraft {
    std::string behavior_id;
    QString plan_path; ///< of a person's own; empty: the robot's
    std::optional<Rectangle> area_in_map;
    std::map<std::string, agent::ParameterValue> values;
    double cell_size_m = mission::Mission{}.cell_size_m;
    QStringList faults; ///< of the embedded simulator, as texts
};

/// Forwards only: intent goes to MissionControl, values go to the views. GUI thread; owns both.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit MainWindow(const Options& options, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Connects to what the command line said. Apart from the constructor, so that the window is seen first.
    void begin();

    MissionControl& control() { return control_; }
    const widgets::CommandRegistry& commands() const { return commands_; }
    const WindowViews& views() const { return views_; }
    DriveDesk& drive() { return drive_; }
    const PlanWorkshop& workshop() const { return workshop_; }
    /// 0 while there is none.
    int selectedRobot() const { return selected_; }

public slots:
    void selectRobot(int id);
    void openMission(const QString& path);
    /// It decides from the next start on.
    void openPlan(const QString& path) { workshop_.openPlan(path); }
    void openRecording(const QString& path) { control_.openRecording(path); }
    /// The embedded simulator goes on from there.
    void openSnapshot(const QString& path);
    /// What the selected robot is set up to do.
    void saveMission(const QString& path);
    void savePicture(const QImage& picture, const QString& path);

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    /// A mission, a plan, a recording, a snapshot, a world's folder or a robot file may be dropped anywhere on the
    /// window.
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void registerCommands();
    void registerFileCommands();
    void registerWorldCommands();
    void registerSnapshotCommands();
    void registerRobotFileCommand();
    void fillWorldMenu(QMenu* menu);
    /// The embedded simulator starts anew in it, once it has been read.
    void chooseWorld(const QString& name_or_folder);
    void wireLoading();
    /// The running simulation continues until the new one is ready, or if loading fails or is canceled.
    void load(const SimulatorSpec& spec, const QString& what);
    void takeLoaded(const SimulatorSpec& spec);
    void cancelLoading();
    /// Because a person wants it so.
    void abandonLoading();
    /// The embedded simulator knows one more robot.
    void openRobotFile(const QString& path);
    void openFile(const QString& path);
    /// The selected robot's time, or where it has none the simulator's.
    void showClock();
    std::vector<agent::RobotDescription> robotsToSpawn(const QStringList& classes) const;
    void registerMissionCommands();
    void registerRobotCommands();
    void registerMapCommands();
    void registerViewCommands();
    void registerLinkCommands();
    void registerTimeCommands();
    void registerLayoutCommands();
    void registerMessageCommands();
    void registerReplayCommands();
    void registerFaultCommands();
    void registerPlanCommands();
    void registerCameraCommands();
    void registerTraceCommands();
    void registerPluginCommands();
    void registerRadioCommands();
    void spawnStation();
    void makeMenus();
    void wireControl();
    void wireRobots();
    void showRobot(int id, const mission::SessionUpdate& update);
    void wireBars();
    void wireMap();
    void wirePanels();
    void wireMission();
    void wireMessages();
    void wireReplay();
    void wireFaults();
    void wirePlan();
    void injectFault();
    /// Enables the fault panel and fills its lists of robots and sensors.
    void showFaultChoices();
    /// Those of the mission file that was opened; their times count from its start.
    void beginMissionFaults();
    void wireCamera();
    void wireDrive();
    void wireObjects();
    /// TRACE for the selected robot, in the color that the palette shows.
    void trace(bool on);
    void showTrace();
    /// Bar and badge of the selected robot.
    void showReplay();
    void orderReplay(const mission::ReplayOrder& order);
    void seekBy(Seconds span);
    void chooseRecording();
    void setRecording(bool on);
    void restoreSettings();
    void saveSettings();
    void restoreMessages();
    void saveMessages(QSettings& settings) const;
    void keepDraft();
    void showDraft();

    void connectTo(widgets::ServerChoice choice, const QString& host, quint16 port);
    /// Also cancels a world that is still loading.
    void disconnectFromServer();
    void showWorld(const WorldPicture& world);
    void spawn(const widgets::SpawnChoice& choice);
    /// The mission's world, where the embedded simulator has another one with nobody in it; else nothing.
    QString worldToOpenFor(const mission::Mission& mission) const;
    void setUp(const mission::Mission& mission);
    void selectRobotFor(const std::string& robot_class);
    void showPlan();
    void showPreview(const Result<agent::TaskPreview>& preview);
    void start();
    /// What is the same for every start.
    void begun(int id);
    /// The behavior that broke, on its robot.
    void startAgain(int id);
    void offerToStartAgain(int id, const QString& key, const QString& text);
    /// Whose behavior broke and was not started again: the selected one, or any; 0: none.
    int brokenRobot() const;
    void give(agent::Order order);
    void refreshRunState();
    void showMessages();
    /// The selected robot's connection, or the one that waits: whose lines are listed, and who gets typed commands.
    void followConnection();
    void applyParameters();
    /// A fast clock without a behavior only runs batteries down.
    void returnToRealTime();
    void showTitle();
    void wirePlugins();
    /// As the settings isolate them: before anything else is read from there.
    void loadPlugins(const QStringList& folders);
    void tellPlugins(const QStringList& folders);
    void tellRefused(const agent::PluginRecord& record);
    /// What was built anew decides from the next start on. `asked` by the person, who is told also that nothing is new.
    void rescanPlugins(bool asked);
    void tellChange(const agent::PluginChange& change);
    /// Reports these changes, then refreshes the robot classes and behaviors that can be chosen.
    void showPlugins(const std::vector<agent::PluginChange>& changes);
    /// Form, plan and isolation of the behavior that is chosen.
    void showChosenBehavior();
    /// Name of the plugin that has the chosen behavior; empty where none has.
    QString chosenPlugin() const;
    void setIsolated(const QString& plugin, bool isolated);
    void applyIsolation();
    void setTheme(widgets::Theme theme);
    void say(Severity severity, const QString& key, const QString& text);
    /// With a button beside the sentence, which does this as long as the trouble is not cured.
    void offer(Severity severity, const QString& key, const QString& text, const widgets::Offer& offer,
               std::function<void()> accept);
    void complain(const QString& key, const Error& error);
    void exportFailed(const QString& reason);
    void chooseImagePort();
    void chooseWhereToSavePicture();
    void chooseWhereToSavePlan();
    void chooseMissionFile();
    void chooseWhereToSaveMission();
    /// Of the start pose that the selected robot was spawned on, or the first one.
    std::string startName() const;
    /// There is a behavior, and an area if it needs one.
    bool mayBeSaved() const;
    bool chooseResultFolder();
    /// One of the built-in layouts: the first one, with the bottom dock `raised` and this part of the height given to
    /// the bottom docks.
    void arrange(const QString& raised, double bottom_part);
    void pauseTime(bool paused);
    /// A plan stands still, or none does any more; what the person paused stays so.
    void holdTime(bool hold);
    void stepTime();
    void setSpeed(double speed);

    static constexpr int layout_version = 5; ///< a layout saved by an older set of docks is not restored

    Options options_;
    MissionControl control_;
    widgets::CommandRegistry commands_;
    WindowViews views_;
    PlanDesk plan_{control_, views_, commands_, this};
    RobotPresenter presenter_;
    std::unique_ptr<CameraDesk> camera_; ///< ends before the views do
    DriveDesk drive_{control_, views_, commands_, this};
    WorldEditor world_{control_, views_, commands_, this};
    PlanWorkshop workshop_{control_, views_, commands_, this};
    RadioPresenter radio_;
    SimulationLoader loader_;
    PluginWatch plugin_watch_;
    WorldPicture world_picture_;        ///< of the embedded simulator
    std::optional<Seconds> server_now_; ///< likewise
    std::vector<protocol::StartPose> start_poses_;
    std::map<int, TaskDraft> drafts_;                     ///< by robot; 0: for the robot that is spawned next
    double cell_size_m_ = mission::Mission{}.cell_size_m; ///< of the height map that is set up
    std::string next_class_;                              ///< of the robot that a mission wants; empty: any
    std::optional<mission::Mission> awaiting_world_;      ///< set up once its world is there
    std::optional<mission::Mission> awaiting_plugin_;     ///< set up once its behavior's process has answered
    QStringList mission_faults_;                          ///< of the mission that is set up
    QStringList isolated_plugins_;                        ///< by name: their behaviors have a process of their own
    std::vector<sim::FaultStatus> faults_;                ///< of the embedded simulator
    std::map<QString, std::function<void()>> offers_;     ///< by the key of the notification
    QByteArray first_layout_;
    int selected_ = 0;
    link::LinkState link_state_ = link::LinkState::Disconnected;
    QTimer preview_due_;      ///< fires when a preview takes long; the panel then says "asking…"
    bool forms_wait_ = false; ///< for the process of the chosen behavior's plugin
    bool asking_ = false;     ///< true while the dialog "save elsewhere?" is open
    bool may_close_ = false;
    bool held_by_plan_ = false; ///< time, not by the person
    QThreadPool disk_;          ///< writes the settings; waited for at the end
};

} // namespace usar::app
