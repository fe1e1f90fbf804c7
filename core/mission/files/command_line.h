// The arguments of one verb of usar-mission, parsed by QCommandLineParser, with errors of our own form.
#pragma once

#include <string>

#include <QCommandLineParser>
#include <QStringList>

#include "core/base/result.h"

namespace usar::mission {

/// Adds these options to the parser and parses `arguments`, which do not include the program's name. Even after an
/// error, the parser has the options that were understood. Errors name the option that is unknown, lacks its value or
/// takes none; `how` says how to write it, or where to read that.
[[nodiscard]] Result<void> parseArguments(QCommandLineParser& parser, const QList<QCommandLineOption>& options,
                                          const QStringList& arguments, const std::string& how);

/// "--speed 10": how errors about a value name it.
std::string asWritten(const QCommandLineParser& parser, const QString& option);

} // namespace usar::mission
