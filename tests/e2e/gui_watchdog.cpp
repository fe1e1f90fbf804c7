#include "tests/e2e/gui_watchdog.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QEvent>
#include <QImage>
#include <QPainter>
#include <QThread>

namespace {

/// How long this thread was ready to run and had no processor, in ms: the second figure of the kernel's schedstat. 0
/// where the kernel does not say. Of the GUI thread alone, which keeps the file open: it is asked at each event.
double waitedForProcessor_ms() {
    static const int file = ::open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
    char text[80];
    const ssize_t bytes = file < 0 ? 0 : ::pread(file, text, sizeof text - 1, 0);
    if (bytes <= 0)
        return 0.0;
    text[bytes] = '\0';
    char* computed_end = nullptr;
    std::strtoull(text, &computed_end, 10);
    return double(std::strtoull(computed_end, nullptr, 10)) / 1e6;
}

double computed_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) / 1e6;
}

/// How often this thread waited for the disk, such as for a font or for the code of a library on its first use.
long waitsForDisk() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_majflt + usage.ru_inblock;
}

/// Some ms of what a window mostly does.
double timeToPaint_ms() {
    QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    const double begin_ms = computed_ms();
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < 60; ++i) {
        painter.fillRect(image.rect(), QColor(i, 2 * i, 3 * i, 40));
        painter.drawText(5, 15 + 4 * i, "the same work, whatever else goes on");
        painter.drawEllipse(QPointF(200, 150), 2.0 * i, i);
    }
    return computed_ms() - begin_ms;
}

} // namespace

GuiWatchdog::Moment GuiWatchdog::now() {
    return {waitedForProcessor_ms(), computed_ms(), waitsForDisk()};
}

/// What of that time the window itself is to blame for.
double GuiWatchdog::blocked_ms(double elapsed_ms, const Moment& before) {
    constexpr double longest_by_disk_ms = 500.0; // what takes longer waits for something else, too
    const Moment after = now();
    if (after.waits_for_disk > before.waits_for_disk && elapsed_ms < longest_by_disk_ms)
        return after.computed_ms - before.computed_ms;
    return elapsed_ms - (after.waited_ms - before.waited_ms);
}

/// Programs beside this one empty the processor's caches and share its units.
double GuiWatchdog::slowness() {
    const double now_ms = timeToPaint_ms();
    undisturbed_ms_ = std::min(undisturbed_ms_, now_ms);
    return now_ms / undisturbed_ms_;
}

bool GuiWatchdog::notify(QObject* receiver, QEvent* event) {
    if (QThread::currentThread() != thread()) // sessions and the simulator may take their time
        return QApplication::notify(receiver, event);
    if (depth_ > 0) // it counts as a part of the event that it comes from
        return QApplication::notify(receiver, event);
    const char* const class_name = receiver->metaObject()->className(); // it may be gone afterwards
    const QString name = receiver->objectName();
    const int type = event->type();
    const Moment before = now();
    QElapsedTimer timer;
    timer.start();
    ++depth_;
    const bool taken = QApplication::notify(receiver, event);
    --depth_;
    if (timer.elapsed() <= longest_ms_)
        return taken;
    double blocked_here_ms = blocked_ms(double(timer.nsecsElapsed()) / 1e6, before);
    if (blocked_here_ms > static_cast<double>(allowed_ms_) / 2)
        blocked_here_ms /= slowness();
    const auto lasted_ms = static_cast<qint64>(blocked_here_ms);
    if (lasted_ms > longest_ms_) {
        longest_ms_ = lasted_ms;
        where_ = QString("%1 %2, event %3").arg(class_name, name).arg(type);
    }
    return taken;
}

GuiWatchdog::GuiWatchdog(int& argc, char** argv) : QApplication(argc, argv), undisturbed_ms_(timeToPaint_ms()) {
    for (int i = 0; i < 10; ++i)
        undisturbed_ms_ = std::min(undisturbed_ms_, timeToPaint_ms());
}

QByteArray GuiWatchdog::complaint() const {
    return longest_ms_ <= allowed_ms_ ? QByteArray()
                                      : QString("%1 ms in %2").arg(longest_ms_).arg(where_).toLocal8Bit();
}

void GuiWatchdog::reset() {
    longest_ms_ = 0;
    where_.clear();
}

void GuiWatchdog::resetStrictly() {
    reset();
    allowed_ms_ = strict_ms;
}
