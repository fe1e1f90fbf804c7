// A double that has to answer while the test's own thread is busy.
#pragma once

#include <QObject>
#include <QThread>

#include "core/link/across_threads.h"

namespace usar::test {

/// `object` lives in a thread of its own as long as this does, and then again where this was made. Talk to it by
/// link::post meanwhile.
class OwnThread {
public:
    explicit OwnThread(QObject& object) : object_(object) {
        object.moveToThread(&thread_);
        thread_.start();
    }
    ~OwnThread() {
        auto come_home = [this] { object_.moveToThread(home_); };
        link::postAndWait(&object_, come_home);
        thread_.quit();
        thread_.wait();
    }
    Q_DISABLE_COPY_MOVE(OwnThread)

private:
    QObject& object_;
    QThread* const home_ = QThread::currentThread();
    QThread thread_;
};

} // namespace usar::test
