// Reads the words of a command that is written for a shell, as the result lines of a campaign have them.
#pragma once

#include <QString>
#include <QStringList>

#include "core/base/result.h"

namespace usar::campaign {

/// Returns the words of a command whose words `shellWord` has written: it is the inverse of that, and no shell. Fails
/// on a quote without its end.
Result<QStringList> shellWords(const QString& command);

} // namespace usar::campaign
