// All views of the window, and the function that makes and places them.
#pragma once

#include <vector>

#include <QDockWidget>
#include <QMainWindow>

#include "widgets/bars/connection_bar.h"
#include "widgets/bars/replay_bar.h"
#include "widgets/bars/result_card.h"
#include "widgets/bars/strips.h"
#include "widgets/bars/time_bar.h"
#include "widgets/campaign/campaign_panel.h"
#include "widgets/commands/command_palette.h"
#include "widgets/drive/camera_view.h"
#include "widgets/drive/control_badge.h"
#include "widgets/drive/drive_panel.h"
#include "widgets/map/layers_panel.h"
#include "widgets/map/map_view.h"
#include "widgets/map/spawn_card.h"
#include "widgets/map/world_panel.h"
#include "widgets/messages/command_box.h"
#include "widgets/messages/message_list.h"
#include "widgets/messages/notification_center.h"
#include "widgets/messages/toast_stack.h"
#include "widgets/panels/behavior_panel.h"
#include "widgets/panels/fault_panel.h"
#include "widgets/panels/history_panel.h"
#include "widgets/panels/instrument_panel.h"
#include "widgets/panels/instruments.h"
#include "widgets/panels/parameter_form.h"
#include "widgets/panels/plot_view.h"
#include "widgets/panels/radio_view.h"
#include "widgets/panels/robot_list.h"
#include "widgets/panels/sensor_panel.h"
#include "widgets/panels/status_strip.h"
#include "widgets/plan/plan_panel.h"
#include "widgets/relief/relief_view.h"

namespace usar::widgets {

/// Pointers to children of the window; valid as long as the window. None is null after `makeViews`.
struct WindowViews {
    // Top bars.
    /// Choice of the server and the state of the link to it.
    ConnectionBar* connection = nullptr;
    /// Simulated time and its controls.
    TimeBar* time = nullptr;
    /// Stops all robots at once.
    QPushButton* stop_all = nullptr;
    /// Whether a recording is being written, and how large it is.
    RecordBadge* record = nullptr;
    ControlBadge* driver = nullptr; ///< shows who drives the selected robot
    DrivePanel* drive = nullptr;    ///< in drive_dock

    // Center: strips above the map, and the map.
    QuestionStrip* question = nullptr; ///< what must be asked while robots go on
    HintStrip* hint = nullptr;         ///< the first steps
    ResultCard* result = nullptr;      ///< how a mission ended
    ProgressStrip* progress = nullptr; ///< visible while a world or snapshot is being opened
    ProgressStrip* saving = nullptr;   ///< visible while results are being written
    ReplayBar* replay = nullptr;       ///< visible while a replay is selected
    MapView* map = nullptr;
    SpawnCard* spawn_card = nullptr; ///< a sheet in the map

    // Contents of the docks.
    /// The list of robots; its selection is that of the window.
    RobotList* robots = nullptr;
    BehaviorPanel* behavior = nullptr;
    ParameterForm* parameters = nullptr; ///< part of `behavior`
    InstrumentPanel* instruments = nullptr;
    // Parts of `instruments`: figures of the behavior, newest scan, ground profile, and sonar ranges.
    StatusStrip* status = nullptr;
    LaserFanView* laser = nullptr;
    TerrainProfileView* terrain = nullptr;
    SonarColumnsView* sonars = nullptr;
    /// Values of all sensors of the selected robot, with their ages.
    SensorPanel* sensors = nullptr;
    CameraView* camera = nullptr;
    PlotView* plots = nullptr;
    PlanPanel* plan = nullptr;
    ReliefView* relief = nullptr;
    MessageList* messages = nullptr;
    CommandBox* command_box = nullptr;
    /// Number of lines in the list, and how many wait while it is paused.
    QLabel* message_count = nullptr;
    QToolButton* traffic = nullptr; ///< line counts of the shown connection
    NotificationCenter* notifications = nullptr;
    /// Warnings and errors, for some seconds at the bottom right of the window.
    ToastStack* toasts = nullptr;
    LayersPanel* layers = nullptr;
    FaultPanel* faults = nullptr;
    HistoryPanel* history = nullptr; ///< what was edited
    CampaignPanel* campaign = nullptr;
    WorldPanel* world = nullptr; ///< palette and list of the world's objects
    QDockWidget* world_dock = nullptr;
    QDockWidget* robots_dock = nullptr;
    RadioView* radio = nullptr;

    // Docks that desks raise or watch.
    QDockWidget* notifications_dock = nullptr;
    QDockWidget* messages_dock = nullptr;
    QDockWidget* plots_dock = nullptr;
    QDockWidget* plan_dock = nullptr;
    QDockWidget* radio_dock = nullptr;
    QDockWidget* drive_dock = nullptr;
    QDockWidget* campaign_dock = nullptr;
    std::vector<QDockWidget*> docks; ///< all docks, in the order of the View menu
};

/// Makes the views and places them as `window.md` describes: the link and the time at the top, what robots should do on
/// the left, the map in the center, what the selected robot perceives on the right, and history at the bottom. To be
/// called once for a window.
WindowViews makeViews(QMainWindow& window);

/// Registers the actions of the message list as commands: gives each an id ("messages.copy") and its keys; texts and
/// help are those of the actions.
void adoptMessageActions(CommandRegistry& commands, const MessageActions& actions);

} // namespace usar::widgets
