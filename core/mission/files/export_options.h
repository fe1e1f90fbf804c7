// The command line of `usar-mission export`.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/mission/files/map_formats.h"
#include "core/usage/program.h"

namespace usar::mission {

/// Options of `usar-mission export`, with their defaults.
struct ExportOptions {
    QString result;     ///< a file of a result, or a recording
    FormatList formats; ///< empty: all that it can give and that are not there yet
    QString folder;     ///< empty: that of the result
    bool operator==(const ExportOptions&) const = default;
};

/// Reads the command line; `arguments` begins with the verb and does not include the program's name.
Result<ExportOptions> readExportOptions(const QStringList& arguments);

/// The verb, for help and pages.
usage::Verb exportVerb();

} // namespace usar::mission
