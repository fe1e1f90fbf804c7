// Desk for the server: connects and disconnects, and opens worlds, snapshots and robot files of the embedded simulator.
#pragma once

#include <QMenu>

#include "app/desks/desk.h"
#include "core/server/embedded/simulation_loader.h"

namespace usar::app {

/// Worlds and snapshots are loaded in the background. The running simulation continues until the new one is ready, or
/// if loading fails or is canceled. GUI thread.
class ServerDesk : public Desk {
    Q_OBJECT
public:
    ServerDesk(const DeskContext& context, const ServerTarget& server) : Desk(context), server_(server) {}

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;
    /// Adds the commands that open a world of the embedded simulator.
    void fillWorldMenu(QMenu* menu) const;

    /// Connects to the server that the command line names.
    void begin();
    /// Restarts the embedded simulator in this world, unless a behavior runs. An error is a notice, here and below.
    void openWorld(const QString& name_or_folder);
    /// Restarts the embedded simulator as usar-mission would start it for a run; its time stands still until there is a
    /// robot. Returns false, with a notice, while a behavior runs.
    bool openRun(const QString& world, quint64 seed, const std::vector<sim::Fault>& faults);
    /// Restarts the embedded simulator from this snapshot.
    void openSnapshot(const QString& path);
    /// Adds a robot class to the embedded simulator, which must be running.
    void openRobotFile(const QString& path);
    /// Name of the world of the connected server, or else of the world in which the embedded simulator will start.
    QString world() const { return control_.level().isEmpty() ? server_.simulator.world : control_.level(); }
    /// Cancels the loading of a world or snapshot, if any.
    void cancelLoading();

signals:
    /// The old world is left, for the embedded simulator or a real server.
    void leavingWorld(bool for_embedded);
    /// The world or snapshot that was being loaded will not be opened, or another one is loaded instead.
    void loadingEnded();
    /// The embedded simulator continues from this snapshot, or has written it.
    void snapshotUsed(const QString& path);

private:
    void registerSimulatorCommands();
    /// True if no behavior runs; otherwise a notice says what to do.
    bool mayLeaveWorld();
    /// Host and port are ignored for the embedded simulator.
    void connectTo(widgets::ServerChoice choice, const QString& host, quint16 port);
    /// Also cancels the loading of a world or snapshot.
    void disconnectFromServer();
    void showLink(const link::LinkStatus& status);
    void showWorld(const server::WorldPicture& world);
    /// Starts loading; `what` is shown above the progress.
    void load(const server::SimulatorSpec& spec, const QString& what);
    /// Starts the embedded simulator with a loaded simulation.
    void takeLoaded(const server::SimulatorSpec& spec);
    /// Cancels loading at the user's request.
    void abandonLoading();
    void learned(const QString& file, const QString& class_name);

    ServerTarget server_; ///< the target of the next connection
    server::SimulationLoader loader_;
    link::LinkState link_state_ = link::LinkState::Disconnected;
};

} // namespace usar::app
