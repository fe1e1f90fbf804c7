// The command line of mission-control as a value.
#pragma once

#include <optional>

#include <QStringList>

#include "app/host/mission_control.h"
#include "core/base/result.h"
#include "widgets/style/theme.h"

namespace usar::app {

/// Default-constructed: the options of a call without arguments.
struct Options {
    /// The server to connect to at the start.
    ServerTarget server;
    QString result_folder;               ///< empty: the default folder
    std::optional<widgets::Theme> theme; ///< nullopt: the one used last
    QStringList plugin_folders;          ///< empty: those that come with the program
    QString mission_file;                ///< mission or plan to open at the start; empty: none
    QString recording;                   ///< recording to replay; then no server is connected; empty: none
};

/// Reads the arguments of the program, the first of which is its name. For --help and --version it ends the program.
/// The error names the option that is wrong.
Result<Options> readOptions(const QStringList& arguments);

} // namespace usar::app
