// What a person does to the world: palette, list and map on one side, the world controller's connection on the other.
#pragma once

#include <vector>

#include <QObject>

#include "app/desks/desk.h"
#include "core/mission/fleet/world_link.h"
#include "core/mission/session/deleted_objects.h"
#include "core/mission/session/world_edits.h"
#include "core/mission/session/world_inventory.h"

namespace usar::app {

/// Connects when the dock is shown for the first time on a server, so that who does not use it costs the server
/// nothing. Asks five times a second while the dock is seen, twice while the map alone shows objects, else never. GUI
/// thread; the window owns it.
class WorldEditor : public QObject {
    Q_OBJECT
public:
    explicit WorldEditor(const DeskContext& context);

    void registerCommands();
    /// After the commands are registered.
    void wire();
    void setPaused(bool paused) { link_.setPaused(paused); }

private:
    /// Follows the connection that MissionControl keeps open.
    void setServer(const link::LinkStatus& status);
    /// The embedded world. Without it an object whose class the server does not tell cannot be brought back.
    void setWorld(const server::WorldPicture& world);
    void registerDeleteCommands();
    void registerWayCommands();
    void wireMap();
    void refresh();
    void refreshPolling();
    void show();
    void showState();
    std::vector<widgets::MapObject> objects() const;
    const widgets::MapObject* selected() const;
    void select(const QString& name);
    void arm();
    void place(const Vec2& at_m, bool again);
    void moveTo(const QString& name, const Vec2& center_m);
    void turn(double angle_rad);
    void spin();
    void remove(const QString& name);
    void setClasses();
    void removeAll();
    void removeNamed(const QStringList& names, const protocol::Command& deletion);
    void addWaypoint(const Vec2& at_m);
    void clearWay();
    void follow(bool moving);
    void send(const protocol::Command& command);
    void say(const QString& text);
    /// Of the embedded world, of what the selected robot has scanned, or guessed from the start poses.
    mission::GroundHeight ground() const;

    MissionControl& control_;
    WindowViews& views_;
    Selection& selection_;
    widgets::CommandRegistry& commands_;
    NoticeDesk& notices_;
    mission::WorldLink link_;
    mission::WorldInventory inventory_;
    mission::DeletedObjects deleted_;
    QString host_;
    quint16 port_ = 0;    ///< 0: no server
    bool opened_ = false; ///< there
    bool dock_seen_ = false;
    double real_time_factor_ = 1.0;
    QString selected_;
    QString awaited_; ///< is selected when it has come
    std::vector<widgets::MapObject> shown_;
};

} // namespace usar::app
