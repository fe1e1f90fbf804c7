// An object that lives in a thread of its own, and calls to it that do not wait.
#pragma once

#include <functional>

#include <QString>
#include <QThread>

#include "core/link/across_threads.h"

namespace usar::mission {

/// Calls a member function of `object` in its thread, with copies of the arguments, and returns at once. The result of
/// the function is lost.
template <class Object, class Function, class... Arguments>
void callLater(Object* object, Function function, Arguments... arguments) {
    link::post(object, [=] { (void)std::invoke(function, object, arguments...); });
}

/// Owns a default-constructed QObject that runs in a thread of its own; the owner may be in any thread. The destructor
/// waits for the thread to end, and the object is deleted there.
template <class Object>
class OwnThread {
public:
    /// `name` is the name of the thread, for debuggers.
    explicit OwnThread(const QString& name) {
        thread_.setObjectName(name);
        object_->moveToThread(&thread_);
        QObject::connect(&thread_, &QThread::finished, object_, &QObject::deleteLater);
        thread_.start();
    }
    ~OwnThread() {
        thread_.quit();
        thread_.wait();
    }

    /// The object, to connect its signals with link::connectAcross.
    Object* get() const { return object_; }
    template <class Function, class... Arguments>
    void call(Function function, Arguments... arguments) const {
        callLater(object_, function, std::move(arguments)...);
    }

private:
    QThread thread_;
    Object* object_ = new Object; ///< belongs to thread_ and is deleted there
};

} // namespace usar::mission
