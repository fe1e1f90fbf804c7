#include "tests/e2e/gui_watchdog.h"

#include <QEvent>
#include <QThread>

bool GuiWatchdog::notify(QObject* receiver, QEvent* event) {
    if (QThread::currentThread() != thread()) // sessions and the simulator may take their time
        return QApplication::notify(receiver, event);
    const QString where = QString("%1 %2, event %3")
                              .arg(receiver->metaObject()->className(), receiver->objectName())
                              .arg(static_cast<int>(event->type()));
    QElapsedTimer timer;
    timer.start();
    ++depth_;
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    if (depth_ == 0 && timer.elapsed() > longest_ms_) {
        longest_ms_ = timer.elapsed();
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
