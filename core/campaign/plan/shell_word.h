// Words of a command for a shell.
#pragma once

#include <QRegularExpression>
#include <QString>

namespace usar::campaign {

/// Returns the word in quotes, unless a POSIX shell takes it as it is.
inline QString shellWord(const QString& word) {
    static const QRegularExpression plain("^[A-Za-z0-9_./:=,@%+-]+$");
    return plain.match(word).hasMatch() ? word : '\'' + QString(word).replace('\'', "'\\''") + '\'';
}

} // namespace usar::campaign
