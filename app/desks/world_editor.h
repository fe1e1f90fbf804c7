// Desk of the world dock: lets the user create, move and delete objects in the world, through a world controller.
#pragma once

#include <map>
#include <set>
#include <vector>

#include <QObject>

#include "app/desks/desk.h"
#include "core/mission/fleet/world_link.h"
#include "core/sim/world/terrain.h"

namespace usar::app {

/// Connects its palette, list and map tools to a world controller on the server. That connection is made when the dock
/// is first shown, so that users who never open it cost the server nothing. Object positions are requested five times a
/// second while the dock is visible, twice a second while only the map shows objects, and otherwise never. GUI thread.
class WorldEditor : public QObject {
    Q_OBJECT
public:
    explicit WorldEditor(const DeskContext& context);

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();
    /// The simulator is paused or runs; while it is paused, its silence is not reported.
    void setPaused(bool paused) { link_.setPaused(paused); }

private:
    /// Follows the connection that MissionControl keeps open.
    void setServer(const link::LinkStatus& status);
    /// Takes over ground and objects of the embedded world. Without them, heights are estimated from the map and the
    /// start poses, and an object whose class the server does not report cannot be brought back.
    void setWorld(const server::WorldPicture& world);
    void registerWayCommands();
    void wireMap();
    /// Connects if that is due, and updates polling, panel and commands.
    void refresh();
    /// Sets how often positions are requested.
    void refreshPolling();
    /// Shows the newest objects in the panel and on the map.
    void show();
    /// Says in the panel why there is no world to edit, if so.
    void showState();
    /// The objects that the server last reported, for the map.
    std::vector<widgets::MapObject> objects() const;
    /// The selected object; nullptr if there is none.
    const widgets::MapObject* selected() const;
    void select(const QString& name);
    void arm();
    /// Creates an object of the chosen class. `again`: the choice stays active for more.
    void place(const Vec2& at_m, bool again);
    /// Moves an object, which keeps its height above ground.
    void moveTo(const QString& name, const Vec2& center_m);
    /// Turns the selected object; counterclockwise is positive.
    void turn(double angle_rad);
    void spin();
    void remove(const QString& name);
    /// `lost`: names of the objects that cannot be brought back.
    void keepForUndo(std::vector<protocol::CreateObject> deleted, const QStringList& lost);
    void setClasses();
    void removeAll();
    /// Creates the objects of the last deletion again. There must be one.
    void undo();
    void addWaypoint(const Vec2& at_m);
    void clearWay();
    void follow(bool moving);
    void send(const protocol::Command& command);
    void say(const QString& text);
    /// Height of the ground in the map frame: of the embedded world, or else of the height map, or else of the nearest
    /// start pose; 0 if nothing is known.
    double ground_m(const Vec2& at_m) const;
    QString unusedName(const QString& class_name) const;
    std::optional<protocol::CreateObject> creationOf(const widgets::MapObject& object) const;

    /// Facts about an object that the server does not report but that were set here.
    struct Known {
        std::vector<Vec2> way_m; ///< way points, map frame
        bool spins = false;
    };

    MissionControl& control_;
    WindowViews& views_;
    widgets::CommandRegistry& commands_;
    NoticeDesk& notices_;
    mission::WorldLink link_;
    std::shared_ptr<const sim::Terrain> ground_;
    std::map<QString, QString> own_objects_; ///< classes of the objects that the embedded world starts with, by name
    QString host_;
    quint16 port_ = 0;    ///< bot port of the server; 0: no server
    bool opened_ = false; ///< the world controller's connection was opened on this server
    bool dock_seen_ = false;
    double real_time_factor_ = 1.0;
    QString selected_; ///< name of the selected object; empty: none
    QString awaited_;  ///< name of a new object that is to be selected when the server reports it
    std::vector<widgets::MapObject> shown_;
    std::map<QString, Known> known_;                           ///< by name
    std::set<QString> used_names_;                             ///< names of objects that were created here
    std::vector<std::vector<protocol::CreateObject>> deleted_; ///< deletions that can be undone, newest last
};

} // namespace usar::app
