// The main window: makes its views, menus and desks, connects them, and saves everything before it closes.
#pragma once

#include <QMainWindow>
#include <QThreadPool>
#include <QTimer>

#include "app/desks/camera_desk.h"
#include "app/desks/campaign_desk.h"
#include "app/desks/drive_desk.h"
#include "app/desks/fault_desk.h"
#include "app/desks/file_desk.h"
#include "app/desks/message_desk.h"
#include "app/desks/mission_desk.h"
#include "app/desks/plan_desk.h"
#include "app/desks/plan_workshop.h"
#include "app/desks/plugin_desk.h"
#include "app/desks/radio_desk.h"
#include "app/desks/replay_desk.h"
#include "app/desks/robot_desk.h"
#include "app/desks/run_flights.h"
#include "app/desks/sample_desk.h"
#include "app/desks/server_desk.h"
#include "app/desks/task_desk.h"
#include "app/desks/test_desk.h"
#include "app/desks/time_desk.h"
#include "app/desks/view_desk.h"
#include "app/desks/world_editor.h"
#include "app/window/recovery_desk.h"
#include "app/window/result_desk.h"

namespace usar::app {

/// Owns MissionControl, the views and the desks. The desks do the work; this class makes them, connects them with each
/// other, and handles what concerns the whole window: title, settings, dropped files and closing. GUI thread.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// Restores the settings of the last time, but neither shows the window nor connects to a server.
    explicit MainWindow(const Options& options, QWidget* parent = nullptr);
    /// Waits until the settings are written.
    ~MainWindow() override;

    /// Connects to the server or opens the files that the command line names. Not part of the constructor, so that the
    /// window can be shown first.
    void begin();
    /// Stops busy robots without a question, saves their scans, and closes.
    void quit();

    // For tests.
    /// Parts of the window; the references are valid as long as it is.
    MissionControl& control() { return control_; }
    const widgets::CommandRegistry& commands() const { return commands_; }
    const widgets::WindowViews& views() const { return views_; }
    DriveDesk& drive() { return drive_; }
    MissionDesk& mission() { return mission_; }
    ServerDesk& server() { return server_; }
    CameraDesk& camera() { return camera_; }
    CampaignDesk& campaigns() { return campaign_; }
    const PlanWorkshop& workshop() const { return workshop_; }
    /// Id of the selected robot; 0 while none is selected.
    RobotId selectedRobot() const { return selection_.id(); }

protected:
    /// Closes at once if no robot is busy and nothing is left to save. Otherwise it asks about the robots in a strip,
    /// saves scans, and closes when that is done; an unsaved plan is asked about.
    void closeEvent(QCloseEvent* event) override;
    /// Leaves out words in a narrow window, so that the time's controls stay visible: a bar that is too long hides its
    /// end.
    void resizeEvent(QResizeEvent* event) override;
    /// Accepts files that the program can open, anywhere on the window.
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void registerCommands();
    /// Fills the menu bar. All commands must be registered before.
    void makeMenus();
    /// Connects MissionControl and the views that need no desk.
    void wire();
    /// Lets each desk make its connections.
    void wireDesks();
    /// Connects signals of one desk with slots of another.
    void connectDesks();
    void restoreSettings();
    /// Writes the settings that have changed since the last time, so that a crash loses a second of them at most. It
    /// happens in a pool thread, because a busy disk may take seconds.
    void saveSettings();
    /// Saves settings and marks recordings once a second from now on.
    void keepSaving();
    /// Shows the progress of the selected robot's behavior in the window's title.
    void showTitle();
    /// Asks what to do with a scan that could not be saved, if the window is about to close.
    void askWhereToSave(const QString& reason);
    /// Asks whether this number of busy robots is to land or to be stopped before the window closes.
    void askBeforeStopping(int busy);
    /// Closes without saving anything more.
    void closeAtOnce();

    Options options_;
    MissionControl control_;
    widgets::CommandRegistry commands_;
    widgets::WindowViews views_;
    Selection selection_{control_};
    NoticeDesk notices_{control_, views_};
    DeskContext desk_{control_, views_, commands_, selection_, notices_, this};
    PluginDesk plugins_;
    ServerDesk server_;
    TaskDesk task_{desk_, plugins_};
    MissionDesk mission_{desk_, server_, task_};
    RobotDesk robots_{desk_};
    PlanDesk plan_{desk_};
    PlanWorkshop workshop_{desk_};
    TimeDesk time_{desk_, plan_};
    DriveDesk drive_{desk_};
    CameraDesk camera_{desk_};
    WorldEditor world_{desk_};
    FileDesk files_{desk_, server_, mission_, workshop_, options_.result_folder.isEmpty()};
    ReplayDesk replay_{desk_};
    TestDesk tests_{desk_};
    MessageDesk messages_{desk_};
    FaultDesk faults_{desk_};
    RadioDesk radio_{desk_};
    RunFlights flights_{desk_, server_, task_};
    CampaignDesk campaign_{desk_, mission_, faults_, flights_};
    SampleDesk samples_{desk_, files_, campaign_};
    ResultDesk results_{desk_};
    ViewDesk view_;
    RecoveryDesk recovery_{desk_, disk_};
    QTimer title_rests_{this}; ///< runs for a second after an update: in fast time every update has new figures
    QString settings_file_ = QSettings().fileName();
    SettingsSheet saved_;    ///< the settings as they were written last
    bool may_stop_ = false;  ///< the user has said that busy robots may be stopped
    bool leaving_ = false;   ///< the window closes when the last busy robot has landed
    bool may_close_ = false; ///< nothing is left to save, or the user gave it up
    QThreadPool disk_;       ///< writes what a crash must not take; its destructor waits for that
};

} // namespace usar::app
