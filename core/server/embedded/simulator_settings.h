// The command line of usar-sim as a value, and the simulation that it describes.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include <QCommandLineParser>

#include "core/base/result.h"
#include "core/server/embedded/simulator_channels.h"
#include "core/sim/simulation.h"
#include "core/usage/program.h"

namespace usar::server {

/// Default-constructed: the settings of a call without arguments, but for the world.
struct SimulatorSettings {
    QString world; ///< name or folder
    quint16 port = protocol::usual_port::bot;
    ChannelPorts channels;
    Access access;
    ImageServerOptions images;
    std::uint64_t seed = 1;
    Pace pace = Pace::Factor;
    double factor = 1.0; ///< simulated seconds per real second
    QString resume;      ///< snapshot to continue from; empty: none
    QString save;        ///< where a snapshot is saved at the end; empty: nowhere
    std::vector<sim::Fault> faults;
    protocol::Dialect profile = protocol::Dialect::Ut2004;
    /// Life of every robot's battery; nullopt: as its file says.
    std::optional<Seconds> battery_life = sim::survey_battery_life;
    std::optional<Seconds> tick{};                                ///< period of STA; nullopt: the profile's own
    std::optional<std::chrono::milliseconds> lockstep_patience{}; ///< nullopt: the server's usual one
};

/// Reads a TCP port, 0 to 65535. The error names the option.
Result<quint16> readPort(const QString& text, const QString& option);

/// Reads the life of a robot's battery, or nullopt from "robot": as the robot's file says. The error names --battery.
Result<std::optional<Seconds>> readBattery(const QString& text);

/// Reads --bind and --allow; the error names the wrong one.
Result<Access> readAccess(const QCommandLineParser& parser);

/// The options that usar-sim and the programs with an embedded simulator share.
QList<QCommandLineOption> sharedOptions();

/// The options of usar-sim, with their help and defaults.
QList<QCommandLineOption> simulatorOptions();
/// The program and these options in words.
usage::Program simulatorProgram();
/// Reads the options of a parser that has parsed the command line. The error names the option that is wrong.
Result<SimulatorSettings> readSimulatorSettings(const QCommandLineParser& parser);

/// Makes the simulation: that of the snapshot, or a new one. Robot files that cannot be read are reported to `refused`
/// and left out. An error names the world or snapshot.
Result<std::unique_ptr<sim::Simulation>> makeSimulation(const SimulatorSettings& settings,
                                                        const std::function<void(const Error&)>& refused);

} // namespace usar::server
