#include "tests/e2e/gui_watchdog.h"

#include <ctime>

#include <sys/resource.h>

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

double computed_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

/// How often this thread waited for the disk to bring a page, such as the code of a library that is used for the first
/// time.
long pagesFromDisk() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_majflt;
}

} // namespace

GuiWatchdog::Moment GuiWatchdog::now() {
    return {waitedForProcessor_ms(), computed_ms(), pagesFromDisk()};
}

/// What of that time the window itself is to blame for.
double GuiWatchdog::blocked_ms(double elapsed_ms, const Moment& before) {
    const Moment after = now();
    if (after.pages_from_disk > before.pages_from_disk)
        return after.computed_ms - before.computed_ms;
    return elapsed_ms - (after.waited_ms - before.waited_ms);
}

bool GuiWatchdog::notify(QObject* receiver, QEvent* event) {
    if (QThread::currentThread() != thread()) // sessions and the simulator may take their time
        return QApplication::notify(receiver, event);
    const QString where = QString("%1 %2, event %3")
                              .arg(receiver->metaObject()->className(), receiver->objectName())
                              .arg(static_cast<int>(event->type()));
    const Moment before = depth_ == 0 ? now() : Moment();
    QElapsedTimer timer;
    timer.start();
    ++depth_;
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    if (depth_ > 0 || timer.elapsed() <= longest_ms_)
        return taken;
    const auto lasted_ms = static_cast<qint64>(blocked_ms(double(timer.nsecsElapsed()) / 1e6, before));
    if (lasted_ms > longest_ms_) {
        longest_ms_ = lasted_ms;
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
