// The window's command line as a value.
#pragma once

#include <optional>

#include <QStringList>

#include "app/host/mission_control.h"
#include "core/base/result.h"
#include "widgets/style/theme.h"

namespace usar::app {

struct Options {
    ServerTarget server;
    QString result_folder;               ///< empty: the default
    std::optional<widgets::Theme> theme; ///< none: the one used last
    QStringList plugin_folders;          ///< empty: those that come with the program
    QString mission_file;                ///< or a plan; opened at the start, if any
    QString recording;                   ///< the same; then no server is connected to
};

/// `arguments` as the program got them, its own name first. Handles --help and --version by ending the program; what is
/// wrong is an error that names the option.
Result<Options> readOptions(const QStringList& arguments);

} // namespace usar::app
