// Prepares a simulation in a thread of its own: reads a world, or replays the run of a snapshot.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QStringList>

#include "core/base/outline.h"
#include "core/protocol/usual_values.h"
#include "core/server/embedded/simulator_channels.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::server {

/// A simulation that has not been started yet, and the robots that it knows.
struct LoadedSimulation {
    std::unique_ptr<sim::Simulation> simulation{};
    QStringList robot_classes{};                              ///< classes that can be spawned, without package
    QStringList camera_classes{};                             ///< those of them that have a camera
    std::map<QString, std::vector<Outline>> robot_outlines{}; ///< footprints (sim::footprintOf), by class
    QStringList refused_robots{};                             ///< one sentence for each robot file that cannot be read
};

/// Everything that an embedded simulator is started with.
struct SimulatorSpec {
    QString world = "tall_test"; ///< name or folder
    QString snapshot{};          ///< file to resume from, with its own world, seed and faults; empty: none
    quint64 seed = 1;
    std::vector<sim::Fault> faults{};
    QStringList robot_files{}; ///< in addition to those that come with the program; they replace equal classes
    /// Bot port. A free one is used instead if it is in use. With 0 it and all channels get free ports.
    quint16 port = protocol::usual_port::bot;
    ChannelPorts channels{};
    Access access{};
    /// Life of every robot's battery; nullopt: as its file says.
    std::optional<Seconds> battery_life = sim::survey_battery_life;
    /// Time stands still until there is a robot, so that a run can be flown again as it was.
    bool time_begins_with_robots = false;
    std::shared_ptr<LoadedSimulation> loaded{}; ///< loaded in advance, for one start; null: the start loads it
};

/// True if the robot carries a camera.
bool hasCamera(const sim::RobotModel& robot);

/// Reads the world, or resumes the snapshot, which takes as long as its run needs unless `watch` cancels it. Blocks;
/// may be called in any thread. The error says what cannot be read.
Result<LoadedSimulation> loadSimulation(const SimulatorSpec& spec, const sim::Simulation::ResumeWatch& watch = {});

/// Loads one simulation at a time. Belongs to the GUI thread; it loads in a thread of its own, and nothing waits for
/// that. A running simulator is not affected: it continues while another one is loaded, and also if loading fails or is
/// canceled.
class SimulationLoader : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    /// Waits until a snapshot's run has reached its next tick, or until the world has been read.
    ~SimulationLoader() override;

    /// Cancels any current loading and starts this one. `loaded` or `refused` follows, unless it is canceled.
    void load(const SimulatorSpec& spec);
    /// Cancels the current loading, if any, without a signal.
    void giveUp();
    bool busy() const { return stop_ != nullptr; }

signals:
    /// While a snapshot is resumed, up to ten times a second: simulated time replayed so far, and in total.
    void progressed(Seconds done, Seconds whole);
    /// `spec` is the requested one with SimulatorSpec::loaded set.
    void loaded(const usar::server::SimulatorSpec& spec);
    /// `reason` gives place, reason and remedy.
    void refused(const QString& reason);

private:
    std::shared_ptr<std::atomic<bool>> stop_; ///< cancels the current loading; null: nothing is being loaded
};

} // namespace usar::server
