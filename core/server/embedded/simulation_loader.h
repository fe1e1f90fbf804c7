// A simulation made ready in a thread of its own: a world that is read, or a snapshot that is lived through again.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include <QObject>
#include <QStringList>

#include "core/protocol/usual_values.h"
#include "core/server/embedded/simulator_channels.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::server {

/// Not started yet, and what was found on the way.
struct LoadedSimulation {
    std::unique_ptr<sim::Simulation> simulation{};
    QStringList robot_classes{};  ///< that can be spawned, without package
    QStringList camera_classes{}; ///< those of them that have a camera
    QStringList refused_robots{}; ///< one sentence for each robot file that cannot be read
};

struct SimulatorSpec {
    QString world = "tall_test"; ///< name or folder
    QString snapshot{};          ///< a file to go on from; world, seed and faults are then its own
    quint64 seed = 1;
    std::vector<sim::Fault> faults{};
    QStringList robot_files{}; ///< beside those that come with the program
    /// Another one is taken where it is in use; 0 chooses free ones for the channels, too.
    quint16 port = protocol::usual_port::bot;
    ChannelPorts channels{};
    std::shared_ptr<LoadedSimulation> loaded{}; ///< ready already, for one start
};

/// Whether the robot carries a camera.
bool hasCamera(const sim::RobotModel& robot);

/// In any thread; takes as long as it takes, but for a snapshot whose run `watch` gives up.
Result<LoadedSimulation> loadSimulation(const SimulatorSpec& spec, const sim::Simulation::ResumeWatch& watch = {});

/// One at a time. Lives in the GUI thread; loading happens in a thread that it owns, and nobody waits for it: while it
/// loads, and where it fails or is given up, whatever runs goes on.
class SimulationLoader : public QObject {
    Q_OBJECT
public:
    explicit SimulationLoader(QObject* parent = nullptr);
    /// Returns when the next tick of a run has been made, or the world has been read.
    ~SimulationLoader() override;

    /// Gives up the one before. `loaded` or `refused` follows, unless it is given up.
    void load(const SimulatorSpec& spec);
    void giveUp();
    bool busy() const { return stop_ != nullptr; }

signals:
    /// Of a snapshot's run, some times a second.
    void progressed(Seconds done, Seconds whole);
    /// With SimulatorSpec::loaded.
    void loaded(const usar::server::SimulatorSpec& spec);
    /// One sentence with place, reason and mend.
    void refused(const QString& reason);

private:
    std::shared_ptr<std::atomic<bool>> stop_; ///< of the one that loads
};

} // namespace usar::server
