// What robots say, put into the views.
#pragma once

#include "app/host/mission_control.h"
#include "app/views/window_views.h"
#include "core/mission/session/trace_watch.h"

namespace usar::app {

/// The map shows every robot; instruments, sensors, plots and the height layer show the selected one. GUI thread.
class RobotPresenter {
public:
    RobotPresenter(MissionControl& control, WindowViews& views) : control_(control), views_(views) {}

    void show(int id, const mission::SessionUpdate& update, bool selected);
    /// Of a connection that has no robot yet: its lines can be read, too. `selected`: no robot is.
    void showLink(int connection, const mission::SessionUpdate& update, bool selected);
    /// Grey what is no longer true of the selected robot: all of it without a link, else each instrument whose sensor
    /// is silent. Without a link no update would say so.
    void showLinkState(int id);
    /// The row in the list and the arrow on the map, as they stand.
    void showRow(int id);
    /// Another robot's height map, marks and path replace those on the map; 0 clears them.
    void select(int id);
    /// Whether it leaves marks.
    bool tracing(int id) const;
    std::optional<protocol::TraceColor> traceColor(int id) const;
    void remove(const QString& name) { views_.map->removeRobot(name); }

private:
    /// A replay was wound back: what was shown of it is void.
    void restart(const RobotView& view, bool selected);
    void showOnMap(const RobotView& view, const mission::SessionUpdate& update, bool selected);
    void showInstruments(const RobotView& view, const mission::SessionUpdate& update);
    void feedPanels(const mission::SessionUpdate& update);
    void feedMessages(int connection, const mission::SessionUpdate& update);
    void showTraffic(const mission::SessionFigures& figures);
    void noteHeard(const mission::SessionUpdate& update);

    MissionControl& control_;
    WindowViews& views_;
    std::map<int, mission::TraceWatch> traces_; ///< by connection
    std::map<int, std::uint64_t> not_shown_;    ///< lines that were left out of updates so far, by connection
    // Of the selected robot:
    widgets::ScanPlane scan_plane_ = widgets::ScanPlane::Below; ///< of the selected robot's scanner
    std::optional<Seconds> scan_heard_;                         ///< by the protocol's clock
    std::optional<Seconds> sonar_heard_;
};

/// Who drives, for chips and lists.
widgets::ControlWords controlWords(const MissionControl& control, const Robot* robot);

} // namespace usar::app
