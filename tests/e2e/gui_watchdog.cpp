#include "tests/e2e/gui_watchdog.h"

#include <QEvent>

bool GuiWatchdog::notify(QObject* receiver, QEvent* event) {
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

void GuiWatchdog::reset() {
    longest_ms_ = 0;
    where_.clear();
}
