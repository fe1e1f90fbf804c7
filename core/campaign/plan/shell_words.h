// Reads the words of a command that is written for a shell, as the result lines of a campaign have them.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/result.h"

namespace usar::campaign {

/// Returns the words of a command, as a POSIX shell would hand them to a program: single quotes, double quotes and
/// backslashes are taken away. It is the inverse of `shellWord`, and expands nothing. Fails on a quote without its end.
Result<QStringList> shellWords(const QString& command);

} // namespace usar::campaign
