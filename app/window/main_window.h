// The window: its views in docks, its menus, its layouts, and how it closes.
#pragma once

#include <QMainWindow>
#include <QThreadPool>

#include "app/desks/camera_desk.h"
#include "app/desks/drive_desk.h"
#include "app/desks/fault_desk.h"
#include "app/desks/file_desk.h"
#include "app/desks/map_desk.h"
#include "app/desks/message_desk.h"
#include "app/desks/mission_desk.h"
#include "app/desks/plan_desk.h"
#include "app/desks/plan_workshop.h"
#include "app/desks/plugin_desk.h"
#include "app/desks/radio_desk.h"
#include "app/desks/replay_desk.h"
#include "app/desks/robot_desk.h"
#include "app/desks/server_desk.h"
#include "app/desks/task_desk.h"
#include "app/desks/time_desk.h"
#include "app/desks/view_desk.h"
#include "app/desks/world_editor.h"
#include "app/window/options.h"

namespace usar::app {

/// Owns MissionControl, the views and the desks, which do the work. GUI thread.
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
    MissionDesk& mission() { return mission_; }
    ServerDesk& server() { return server_; }
    CameraDesk& camera() { return camera_; }
    const PlanWorkshop& workshop() const { return workshop_; }
    /// 0 while no robot is selected.
    int selectedRobot() const { return selection_.id(); }

protected:
    void closeEvent(QCloseEvent* event) override;
    /// The time's controls before words that can be done without: a bar that is too narrow hides its end.
    void resizeEvent(QResizeEvent* event) override;
    /// Files of ours may be dropped anywhere on the window.
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void registerCommands();
    void wire();
    void wireDesks();
    /// What one desk tells another.
    void connectDesks();
    void restoreSettings();
    /// A thread of the pool writes them: a busy disk takes seconds.
    void saveSettings();
    void showTitle();
    void askWhereToSave(const QString& reason);
    void closeAtOnce();

    Options options_;
    MissionControl control_;
    widgets::CommandRegistry commands_;
    WindowViews views_;
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
    FileDesk files_{desk_, server_, mission_, workshop_};
    ReplayDesk replay_{desk_};
    MessageDesk messages_{desk_};
    FaultDesk faults_{desk_};
    RadioDesk radio_{desk_};
    MapDesk map_{desk_};
    ViewDesk view_;
    bool asking_ = false; ///< true while the dialog "save elsewhere?" is open
    bool may_close_ = false;
    QThreadPool disk_; ///< writes the settings; waited for at the end
};

} // namespace usar::app
