// The user's edits of the world: connects the palette, the list and the map to the world controller.
#pragma once

#include <vector>

#include "app/desks/desk.h"
#include "core/mission/fleet/world_link.h"
#include "core/mission/world/world_editing.h"

namespace usar::app {

/// Connects when the dock is first shown, an object is selected or one is edited on a server, so that the server has no
/// load from users who do not need it; until then the embedded simulator tells where its objects are when one has
/// moved. Polls five times a second while the dock is visible, twice a second while only the map shows objects, else
/// never. Belongs to the GUI thread; owned by the window.
class WorldEditor : public Desk {
    Q_OBJECT
public:
    explicit WorldEditor(const DeskContext& context);

    void registerCommands() override;
    void wire() override;
    /// While the simulator is paused it answers nothing, and that is not reported.
    void setPaused(bool paused) { link_.setPaused(paused); }
    /// While the user drives, W drives forward; so way points are not added then, and their command says why.
    void setDriving(bool drives);

private:
    /// Follows the connection that MissionControl keeps open.
    void setServer(const link::LinkStatus& status);
    /// Sets the embedded simulator's world. Without it, a deleted object whose class the server does not report cannot
    /// be restored.
    void setWorld(const server::WorldPicture& world);
    /// Registers the commands for way points, and those that start and stop an object or a belt.
    void registerWayCommands();
    void wireMap();
    /// Opens the connection to the server, if there is one and it is not open yet.
    void open();
    /// Opens the connection when the dock is visible for the first time, and updates polling and state.
    void refresh();
    /// How often to ask where the objects are; nullopt while nobody looks at them.
    std::optional<std::chrono::milliseconds> polling() const;
    /// The server has answered as a world controller on this connection.
    bool answers() const { return opened_ && link_.view().state == mission::WorldState::Ready; }
    /// Shows the newest objects, and selects the one that was just placed as soon as it appears.
    void show();
    /// Covers the panel with the reason if no objects can be edited: no server, no world controller, or no answer yet.
    void showState();
    /// The objects in the map frame, with speeds converted to simulated time.
    std::vector<widgets::MapObject> objects() const;
    /// The selected object; nullptr if there is none. Valid until the next `show`.
    const widgets::MapObject* selected() const;
    std::string selectedName() const { return selected_.toStdString(); }
    void select(const QString& name);
    /// Lets the map place the object chosen in the palette; ends placing if none is chosen.
    void arm();
    /// Creates the chosen object on the ground at this point. `again`: the palette stays pressed for the next one.
    void place(const Vec2& at_m, bool again);
    /// Moves the object's center here, at the same height over the ground.
    void moveTo(const QString& name, const Vec2& center_m);
    void remove(const QString& name) { tellLost(edits_.remove(name.toStdString())); }
    /// Sets the classes that the server is asked about, to learn which objects belong to each.
    void setClasses();
    /// A notice names the deleted objects that undo cannot restore.
    void tellLost(const std::vector<std::string>& lost);
    /// Appends a way point to the way of the selected object; says what to do if none is selected.
    void addWaypoint(const Vec2& at_m);
    /// Starts or stops the selected object's motion along its way, or its belt.
    void follow(bool moving);
    void say(const QString& text) { notices_.say(Severity::Warning, "world", text); }

    mission::WorldLink link_;
    mission::WorldEditing edits_;
    QString host_;
    quint16 port_ = 0;    ///< 0: no server
    bool opened_ = false; ///< the connection to `host_` has been requested
    bool dock_seen_ = false;
    bool driving_ = false; ///< the user drives a robot
    /// Simulated seconds per wall second, of the embedded simulator.
    double real_time_factor_ = 1.0;
    /// Name of the selected object; empty: none.
    QString selected_;
    QString awaited_; ///< name of an object to select as soon as it appears
    std::vector<widgets::MapObject> shown_;
};

} // namespace usar::app
