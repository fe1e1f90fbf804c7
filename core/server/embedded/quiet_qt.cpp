#include "core/server/embedded/quiet_qt.h"

#include <QString>
#include <QtGlobal>

namespace usar::server {

namespace {

QtMessageHandler shown_by = nullptr;

void show(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (!message.startsWith(QLatin1String("QStandardPaths: XDG_RUNTIME_DIR not set")))
        shown_by(type, context, message);
}

} // namespace

void keepQtQuiet() {
    shown_by = qInstallMessageHandler(show);
}

} // namespace usar::server
