// Waiting for conditions. That something does not happen is tested until something else has happened, and not for a
// time.
#pragma once

#include <QEventLoop>
#include <QTest>
#include <QTimer>

namespace usar::test {

/// Runs the event loop until `enough` holds. True if `calm` held at each look until then; false at the first look at
/// which it did not, or where `enough` did not come in time. Both are callables that return bool.
template <class Calm, class Enough>
bool holdsUntil(Calm calm, Enough enough, int timeout_ms = 15000) {
    bool broken = false;
    const bool came = QTest::qWaitFor(
        [&] {
            broken = !calm();
            return broken || enough();
        },
        timeout_ms);
    return came && !broken && calm();
}

/// Runs the event loop until the object gives the signal. False after `timeout_ms` without it. Qt Test's own waits
/// sleep 10 ms between two looks.
template <class Object, class Signal>
bool waitForSignal(Object* object, Signal signal, int timeout_ms) {
    QEventLoop loop;
    bool came = false;
    QObject::connect(object, signal, &loop, [&] {
        came = true;
        loop.quit();
    });
    QTimer::singleShot(timeout_ms, &loop, &QEventLoop::quit);
    loop.exec();
    return came;
}

/// Lets the event loop do what is due, sockets included.
inline void turnEventLoop() {
    QEventLoop loop;
    QTimer::singleShot(0, &loop, &QEventLoop::quit);
    loop.exec();
}

/// Counts the turns of a timer of this thread, for what a timer of the same length might do: beside much else both are
/// late.
class Beats {
public:
    explicit Beats(int every_ms) {
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { ++count_; });
        timer_.start(every_ms);
    }
    int count() const { return count_; }

private:
    QTimer timer_;
    int count_ = 0;
};

} // namespace usar::test
