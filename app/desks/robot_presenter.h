// Shows the robots' updates in the views of the window.
#pragma once

#include "app/desks/selection.h"
#include "app/host/mission_control.h"
#include "core/mission/fleet/equipment_questions.h"
#include "core/mission/fleet/trace_watch.h"
#include "widgets/models/sensor_model.h"
#include "widgets/window/window_views.h"

namespace usar::app {

/// The map shows every robot; instruments and sensors show the selected one. The plots record every robot. GUI thread.
class RobotPresenter {
public:
    RobotPresenter(MissionControl& control, widgets::WindowViews& views, const Selection& selection)
        : control_(control)
        , views_(views)
        , selection_(selection) {}

    /// Shows an update of the robot `id`, which must exist.
    void show(RobotId id, const std::shared_ptr<const mission::SessionUpdate>& shared);
    /// Shows the lines of the connection that has no robot yet, and its figures while no robot is selected.
    void showLink(const std::shared_ptr<const mission::SessionUpdate>& update);
    /// Grays out what is out of date about the selected robot: everything without a link, otherwise each instrument
    /// whose sensor is silent. To be called when the link changes, because a lost link sends no updates.
    void showLinkState(RobotId id);
    /// Updates the robot's row in the list and its arrow on the map.
    void showRow(RobotId id);
    /// Replaces the path on the map and all instruments by those of this robot; 0 clears them.
    void select(RobotId id);
    /// Color of the marks that the robot leaves; nullopt while it leaves none, and for id 0.
    std::optional<protocol::TraceColor> tracing(RobotId id) const;
    void remove(const QString& name) {
        views_.map->removeRobot(name);
        views_.plots->forget(name);
    }

private:
    /// The newest words of a robot, and the questions that it is asked.
    struct Heard {
        widgets::NewestLines newest;
        widgets::RobotInstruments instruments;
        mission::EquipmentQuestions questions;
    };
    /// With the outline of its robot file or, on another server, of the size that it tells.
    widgets::MapRobot onMap(const RobotView& view);
    /// Clears what was shown of a replay that was rewound.
    void restart(const RobotView& view, bool selected);
    void extendTrail(const RobotView& view, const mission::SessionUpdate& update);
    void showOnMap(const RobotView& view, const mission::SessionUpdate& update, bool selected);
    void showStatus(const RobotView& view);
    void showInstruments(const RobotView& view);
    /// Asks the robot for what its instruments must know.
    void ask(Robot& robot);
    void feedMessages(ConnectionId connection, const mission::SessionUpdate& update);
    void showTraffic(const mission::SessionFigures& figures);

    MissionControl& control_;
    widgets::WindowViews& views_;
    const Selection& selection_;
    std::map<ConnectionId, mission::TraceWatch> traces_; ///< by connection
    std::map<ConnectionId, Heard> heard_;                ///< kept for every robot until it is selected
    widgets::Footprints footprints_;
    std::map<ConnectionId, std::uint64_t> not_shown_; ///< number of lines left out of updates so far, by connection
};

/// Says who drives the robot, for chips and lists. `robot` may be null; then the words are empty.
widgets::ControlWords controlWords(const MissionControl& control, const Robot* robot);

} // namespace usar::app
