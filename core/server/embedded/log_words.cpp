#include "core/server/embedded/log_words.h"

#include <QObject>
#include <QRegularExpression>

namespace usar::server {

QString noticeOfLog(const QString& logged) {
    static const QRegularExpression of_client(QStringLiteral("^client \\d+: (.*)$"));
    const QRegularExpressionMatch match = of_client.match(logged);
    if (!match.hasMatch())
        return logged;
    const QString what = match.captured(1);
    if (what == QStringLiteral("connected") || what == QStringLiteral("gone"))
        return {};
    return QObject::tr("Simulator: %1").arg(what);
}

} // namespace usar::server
