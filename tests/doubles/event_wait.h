// Waiting for a signal at the speed of the event loop; Qt Test's waits sleep 10 ms between two looks.
#pragma once

#include <QEventLoop>
#include <QTimer>

namespace usar::test {

/// Runs the event loop until the object gives the signal. False after `timeout_ms` without it.
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

} // namespace usar::test
