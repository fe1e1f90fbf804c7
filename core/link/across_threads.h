// Calls and signals from one thread to another: the one place where this project posts to a thread.
#pragma once

#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

#include <QObject>

#include "core/base/hand_over.h"

namespace usar::link {

/// Makes the call in the thread in which `where` lives: at once if that is this thread, else from its event loop. A
/// call that has not been made when `where` goes is not made.
template <class Call>
void post(QObject* where, Call call) {
    QMetaObject::invokeMethod(where, HandedOver(std::move(call)));
}

/// Makes the call in the thread in which `where` lives, which must be another one, and returns when it has been made.
template <class Call>
void postAndWait(QObject* where, Call& call) {
    QMetaObject::invokeMethod(where, HandedOver([&call] { call(); }), Qt::BlockingQueuedConnection);
}

/// Connects a signal of an object that lives in another thread. The slot (a member function of the receiver, its
/// signals included, or anything else that can be called) gets copies of the arguments, in the thread in which the
/// receiver lives. As with Qt's own connections, the receiver must not go while the sender may still give the signal:
/// it waits for the sender's thread, or disconnects in it.
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
