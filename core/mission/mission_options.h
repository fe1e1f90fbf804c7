// The command line of `usar-mission run`.
#pragma once

#include <cstdint>
#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/result.h"

namespace usar::mission {

/// A server to connect to.
struct ServerAddress {
    QString host;
    quint16 port = 3000;
    bool operator==(const ServerAddress&) const = default;
};

struct MissionOptions {
    QString mission_file;
    QString behavior; ///< empty: the file's
    QString plan;     ///< file of a POSH plan; empty: the mission's, or the robot's own
    std::uint64_t seed = 1;
    std::optional<double> speed_x;       ///< absent: as fast as it can
    std::optional<ServerAddress> server; ///< absent: the embedded simulator
    QString result_folder;               ///< empty: default
    QString recording;                   ///< empty: none
    QStringList faults;                  ///< besides the mission's
    QStringList plugin_folders;          ///< besides those that come with the program
    bool isolate = false;                ///< also where the mission does not ask for it
    bool help = false;
    bool operator==(const MissionOptions&) const = default;
};

/// "HOST", "HOST:PORT" or "[IPV6]:PORT".
Result<ServerAddress> readServerAddress(const QString& text);

/// `arguments` without the program's name. Errors name the option and how to write it.
Result<MissionOptions> readMissionOptions(const QStringList& arguments);

/// What `--help` prints.
QString missionHelp();

} // namespace usar::mission
