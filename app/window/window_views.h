// All views of the window, made and placed once.
#pragma once

#include <vector>

#include <QDockWidget>
#include <QMainWindow>

#include "widgets/behavior_panel.h"
#include "widgets/camera_view.h"
#include "widgets/command_box.h"
#include "widgets/command_palette.h"
#include "widgets/connection_bar.h"
#include "widgets/control_badge.h"
#include "widgets/drive_panel.h"
#include "widgets/fault_panel.h"
#include "widgets/hint_strip.h"
#include "widgets/laser_fan_view.h"
#include "widgets/layers_panel.h"
#include "widgets/map_view.h"
#include "widgets/message_list.h"
#include "widgets/notification_center.h"
#include "widgets/parameter_form.h"
#include "widgets/plan_panel.h"
#include "widgets/plot_view.h"
#include "widgets/progress_strip.h"
#include "widgets/radio_view.h"
#include "widgets/record_badge.h"
#include "widgets/replay_bar.h"
#include "widgets/robot_list.h"
#include "widgets/sensor_panel.h"
#include "widgets/sonar_columns_view.h"
#include "widgets/spawn_card.h"
#include "widgets/status_strip.h"
#include "widgets/stop_button.h"
#include "widgets/terrain_profile_view.h"
#include "widgets/time_bar.h"
#include "widgets/toast_stack.h"
#include "widgets/world_panel.h"

namespace usar::app {

/// Pointers to children of the window; valid as long as the window is.
struct WindowViews {
    widgets::ConnectionBar* connection = nullptr;
    widgets::TimeBar* time = nullptr;
    widgets::StopButton* stop_all = nullptr;
    widgets::RecordBadge* record = nullptr;
    widgets::ControlBadge* driver = nullptr; ///< who drives the selected robot
    widgets::DrivePanel* drive = nullptr;
    widgets::HintStrip* hint = nullptr;
    widgets::ProgressStrip* progress = nullptr; ///< visible while a world or snapshot is opened
    widgets::ReplayBar* replay = nullptr;       ///< visible while a replay is selected
    widgets::MapView* map = nullptr;
    widgets::SpawnCard* spawn_card = nullptr;
    widgets::RobotList* robots = nullptr;
    widgets::BehaviorPanel* behavior = nullptr;
    widgets::ParameterForm* parameters = nullptr;
    widgets::StatusStrip* status = nullptr;
    widgets::LaserFanView* laser = nullptr;
    widgets::TerrainProfileView* terrain = nullptr;
    widgets::SonarColumnsView* sonars = nullptr;
    widgets::SensorPanel* sensors = nullptr;
    widgets::CameraView* camera = nullptr;
    widgets::PlotView* plots = nullptr;
    widgets::PlanPanel* plan = nullptr;
    widgets::MessageList* messages = nullptr;
    widgets::CommandBox* command_box = nullptr;
    QLabel* message_count = nullptr;
    QToolButton* traffic = nullptr; ///< counters of the shown connection
    widgets::NotificationCenter* notifications = nullptr;
    widgets::ToastStack* toasts = nullptr;
    widgets::LayersPanel* layers = nullptr;
    widgets::FaultPanel* faults = nullptr;
    widgets::WorldPanel* world = nullptr; ///< the palette
    QDockWidget* world_dock = nullptr;
    widgets::RadioView* radio = nullptr;
    QDockWidget* notifications_dock = nullptr;
    QDockWidget* messages_dock = nullptr;
    QDockWidget* plots_dock = nullptr;
    QDockWidget* plan_dock = nullptr;
    QDockWidget* radio_dock = nullptr;
    QDockWidget* drive_dock = nullptr;
    std::vector<QDockWidget*> docks; ///< in the order of the View menu
};

/// Makes the views, the top bar, the center and the docks of `window.md`: intent on the left, perception on the right,
/// history below.
WindowViews makeViews(QMainWindow& window);

} // namespace usar::app
