#include "tests/e2e/gui_watchdog.h"

#include <QEvent>
#include <QFile>
#include <QThread>

namespace {

/// How long this thread was ready to run and had no processor, in ms: the second figure of the kernel's schedstat. 0
/// where the kernel does not say.
double waitedForProcessor_ms() {
    QFile file("/proc/thread-self/schedstat");
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    return file.readLine(80).split(' ').value(1).toDouble() / 1e6;
}

} // namespace

bool GuiWatchdog::notify(QObject* receiver, QEvent* event) {
    if (QThread::currentThread() != thread()) // sessions and the simulator may take their time
        return QApplication::notify(receiver, event);
    const QString where = QString("%1 %2, event %3")
                              .arg(receiver->metaObject()->className(), receiver->objectName())
                              .arg(static_cast<int>(event->type()));
    const double waited_ms = depth_ == 0 ? waitedForProcessor_ms() : 0.0;
    QElapsedTimer timer;
    timer.start();
    ++depth_;
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    if (depth_ > 0 || timer.elapsed() <= longest_ms_)
        return taken;
    const auto blocked_ms = timer.elapsed() - static_cast<qint64>(waitedForProcessor_ms() - waited_ms);
    if (blocked_ms > longest_ms_) {
        longest_ms_ = blocked_ms;
        where_ = where;
    }
    return taken;
}

QByteArray GuiWatchdog::complaint() const {
    return longest_ms_ <= allowed_ms ? QByteArray() : QString("%1 ms in %2").arg(longest_ms_).arg(where_).toLocal8Bit();
}

void GuiWatchdog::reset() {
    longest_ms_ = 0;
    where_.clear();
}
