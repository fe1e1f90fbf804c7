// The command line of mission-control as a value.
#pragma once

#include <optional>

#include <QStringList>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/server/embedded/server_target.h"
#include "core/usage/program.h"

namespace usar::server {

/// Default-constructed: the options of a call without arguments.
struct WindowOptions {
    /// The server to connect to at the start.
    ServerTarget server;
    QString result_folder;       ///< empty: the default folder
    QString theme;               ///< "light", "dark" or "system"; empty: the one used last
    QStringList plugin_folders;  ///< empty: those that come with the program
    QString mission_file;        ///< mission or plan to open at the start; empty: none
    QString recording;           ///< recording to replay; then no server is connected; empty: none
    std::optional<Seconds> at{}; ///< moment of the recording at which it opens; absent: its beginning
    QString select;              ///< name of the robot to select as soon as it is there; empty: none
};

/// The program and its options in words.
usage::Program windowProgram();
/// Reads the arguments of the program, the first of which is its name. The error names the option that is wrong.
Result<WindowOptions> readWindowOptions(const QStringList& arguments);

} // namespace usar::server
