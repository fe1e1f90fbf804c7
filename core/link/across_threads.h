// Calls and signals from one thread to another. All posting between threads in this project is done with these
// functions.
#pragma once

#include <functional>
#include <latch>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

#include <QObject>

#include "core/base/hand_over.h"

namespace usar::link {

/// Runs the call in the thread of `where`: at once if that is the current thread, else from its event loop. A call that
/// is still queued when `where` is destroyed is dropped.
template <class Call>
void post(QObject* where, Call call) {
    QMetaObject::invokeMethod(where, HandedOver(std::move(call)));
}

/// Runs the call in the thread of `where`, which must not be the current thread, and returns when the call has
/// finished, or was dropped because `where` is destroyed.
template <class Call>
void postAndWait(QObject* where, Call& call) {
    // Qt's own way to wait lets the other thread read the stack of this one in a manner that ThreadSanitizer cannot see
    // the end of. Here the last copy of the posted call opens the latch, when it has run or was dropped.
    const auto ended = std::make_shared<std::latch>(1);
    post(where, [&call, last = std::shared_ptr<void>(nullptr, [ended](void*) { ended->count_down(); })] { call(); });
    ended->wait();
}

/// Connects a signal of an object in another thread. The slot (a member function of the receiver, including its
/// signals, or any other callable) gets copies of the arguments and runs in the receiver's thread. As with Qt's own
/// connections, the receiver must not be destroyed while the sender may still emit the signal: it waits for the
/// sender's thread to end, or disconnects in that thread.
template <class Sender, class... Arguments, class Receiver, class Slot>
QMetaObject::Connection connectAcross(const Sender* sender, void (Sender::*signal)(Arguments...), Receiver* receiver,
                                      Slot slot) {
    return QObject::connect(
        sender, signal, receiver,
        [receiver, slot](const std::decay_t<Arguments>&... arguments) {
            post(receiver, [receiver, slot, copies = std::tuple<std::decay_t<Arguments>...>(arguments...)] {
                std::apply(
                    [&](const auto&... each) {
                        if constexpr (std::is_member_function_pointer_v<Slot>)
                            std::invoke(slot, receiver, each...);
                        else
                            std::invoke(slot, each...);
                    },
                    copies);
            });
        },
        Qt::DirectConnection);
}

} // namespace usar::link
