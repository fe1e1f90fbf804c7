// The user's edits of the world: connects the palette, the list and the map to the world controller.
#pragma once

#include <vector>

#include "app/desks/desk.h"
#include "core/mission/fleet/world_link.h"
#include "core/mission/world/deleted_objects.h"
#include "core/mission/world/world_edits.h"
#include "core/mission/world/world_inventory.h"

namespace usar::app {

/// Connects when the dock is first shown on a server, so that the server has no load from users who do not need it.
/// Polls five times a second while the dock is visible, twice a second while only the map shows objects, else never.
/// Belongs to the GUI thread; owned by the window.
class WorldEditor : public Desk {
    Q_OBJECT
public:
    explicit WorldEditor(const DeskContext& context);

    void registerCommands() override;
    void wire() override;
    void setPaused(bool paused) { link_.setPaused(paused); }

private:
    /// Follows the connection that MissionControl keeps open.
    void setServer(const link::LinkStatus& status);
    /// Sets the embedded simulator's world. Without it, a deleted object whose class the server does not report cannot
    /// be restored.
    void setWorld(const server::WorldPicture& world);
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
    void say(const QString& text);
    /// Returns the ground height, from the embedded world, the selected robot's scan, or a guess from the start poses.
    mission::GroundHeight ground() const;

    mission::WorldLink link_;
    mission::WorldInventory inventory_;
    mission::DeletedObjects deleted_;
    QString host_;
    quint16 port_ = 0;    ///< 0: no server
    bool opened_ = false; ///< the connection to `host_` has been requested
    bool dock_seen_ = false;
    double real_time_factor_ = 1.0;
    QString selected_;
    QString awaited_; ///< name of an object to select as soon as it appears
    std::vector<widgets::MapObject> shown_;
};

} // namespace usar::app
