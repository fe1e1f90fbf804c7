// The command line of `usar-mission run`.
#pragma once

#include <cstdint>
#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/mission/files/map_formats.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/files/result_writer.h"
#include "core/protocol/usual_values.h"
#include "core/usage/program.h"

namespace usar::mission {

/// A server to connect to.
struct ServerAddress {
    QString host;
    quint16 port = protocol::usual_port::bot;
    bool operator==(const ServerAddress&) const = default;
};

/// Options of `usar-mission run`, with their defaults.
struct MissionOptions {
    QString mission_file;          ///< empty: that of the recording in `continued`
    QString continued;             ///< recording of a run that was cut off, whose rest is to be flown; or empty
    QString behavior;              ///< empty: the one in the mission file
    QString plan;                  ///< file of a POSH plan; empty: the mission's plan, or the robot's own
    std::uint64_t seed = 1;        ///< of the embedded simulator's noise and drift; the mission's own is not put here
    bool seed_chosen = false;      ///< the seed was typed; without that, a continued run keeps its own
    std::optional<double> speed_x; ///< simulated per real seconds; absent: as fast as possible
    std::optional<ServerAddress> server; ///< absent: the embedded simulator
    std::optional<double>
        battery_life_s;           ///< It holds for the embedded simulator's robots; without it, a battery lasts a week.
    std::optional<Seconds> limit; ///< the run is given up after this simulated time; absent: the mission's limit
    QString result_folder;        ///< empty: the default folder
    ResultFiles files = ResultFiles::Always;
    FormatList formats;                                   ///< in which the map is written besides the usual files
    QString recording;                                    ///< file to record to; empty: none
    std::optional<std::uint64_t> recording_limit_bytes{}; ///< most bytes that it keeps; absent: any number
    QStringList faults;                                   ///< in addition to the mission's
    QStringList values;                                   ///< KEY=VALUE to put over the mission's; see setValue
    QStringList plugin_folders;                           ///< in addition to the plugins that come with the program
    bool isolate = false;                                 ///< on even if the mission does not ask for it
    std::optional<bool> adjust;                           ///< whether the map is adjusted; absent: as the mission says
    bool one_thread = false;                              ///< the behavior has no thread of its own
    bool course = false;                                  ///< the summary tells how the run went, see RunCourse
    bool operator==(const MissionOptions&) const = default;
};

/// Reads "HOST", "HOST:PORT" or "[IPV6]:PORT". Without a port it is 3000. Fails on a port outside 1..65535 or an empty
/// host.
Result<ServerAddress> readServerAddress(const QString& text);

/// Reads the command line; `arguments` does not include the program's name. Errors name the option and how to write it.
Result<MissionOptions> readMissionOptions(const QStringList& arguments);

/// Puts the command line's values, behavior, plan and isolation over those of the file: what was typed takes
/// precedence, and errors about it do not name the file. A relative path of a plan begins at the current folder. Fails
/// on a value that does not fit.
Result<void> applyTo(Mission& mission, const MissionOptions& options);

/// The simulated time after which the run is given up: that of the command line, or else the mission's; infinite if
/// neither sets one.
Seconds limitOf(const MissionOptions& options, const Mission& mission);

/// Fails if faults are requested together with a server: only the embedded simulator can make them.
Result<void> checkFaultsArePossible(const MissionOptions& options, const Mission& mission);

/// The verb and its options in words.
usage::Verb runVerb();

} // namespace usar::mission
