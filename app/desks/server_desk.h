// The server: connecting and disconnecting, and what the embedded simulator is started with.
#pragma once

#include <QMenu>
#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"
#include "core/server/embedded/simulation_loader.h"

namespace usar::app {

/// Worlds and snapshots are loaded beside the running simulation, which continues until the new one is ready, or if
/// loading fails or is canceled. GUI thread.
class ServerDesk : public QObject {
    Q_OBJECT
public:
    ServerDesk(const DeskContext& context, const ServerTarget& server);

    void registerCommands();
    void wire();
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;
    void fillWorldMenu(QMenu* menu) const;

    /// Connects to what the command line said.
    void begin();
    void openWorld(const QString& name_or_folder);
    /// The embedded simulator continues from there.
    void openSnapshot(const QString& path);
    /// The embedded simulator can spawn one more class of robot.
    void openRobotFile(const QString& path);
    /// The world that the embedded simulator is in, or begins in.
    QString world() const;
    /// Nobody waits any longer for a world that is still loading.
    void cancelLoading();
    link::LinkState linkState() const { return link_state_; }

signals:
    /// The old world is gone from now on.
    void leavingWorld(bool for_embedded);
    /// The world that was being loaded will not come.
    void loadingEnded();

private:
    void registerLinkCommands();
    void registerWorldCommands();
    void registerSnapshotCommands();
    void registerRobotFileCommand();
    void wireLoading();
    void wireSimulator();
    void connectTo(widgets::ServerChoice choice, const QString& host, quint16 port);
    /// Also cancels a world that is still loading.
    void disconnectFromServer();
    void showLink(const link::LinkStatus& status);
    void showWorld(const server::WorldPicture& world);
    void load(const server::SimulatorSpec& spec, const QString& what);
    void takeLoaded(const server::SimulatorSpec& spec);
    /// The user canceled it.
    void abandonLoading();
    void learned(const QString& file, const QString& class_name);

    DeskContext desk_;
    ServerTarget server_; ///< what the next connection is made to
    server::SimulationLoader loader_;
    link::LinkState link_state_ = link::LinkState::Disconnected;
};

} // namespace usar::app
