// A call that one thread makes ready and another one makes.
#pragma once

#include <type_traits>
#include <utility>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace usar {

/// Debian's Qt is not built for ThreadSanitizer, which therefore does not see that an event is posted before it is
/// delivered, and takes each value in it for a race. This marks the order: what was written before the call came to
/// rest where it is now was written before it is made, and what the call has written was written before it is
/// destroyed. Without ThreadSanitizer it is the call and nothing else.
template <class Call>
class HandedOver {
public:
    explicit HandedOver(Call call) : call_(std::move(call)) { release(); }
    HandedOver(HandedOver&& other) noexcept(std::is_nothrow_move_constructible_v<Call>)
        : call_(std::move(other.call_)) {
        release();
    }
    HandedOver(const HandedOver& other) : call_(other.call_) { release(); }
    HandedOver& operator=(const HandedOver&) = delete;
    HandedOver& operator=(HandedOver&&) = delete;
    ~HandedOver() { acquire(); }

    /// In the other thread.
    void operator()() {
        acquire();
        call_();
        release();
    }

private:
#ifdef __SANITIZE_THREAD__
    void release() {
        __tsan_release(this);
    }
    void acquire() {
        __tsan_acquire(this);
    }
#else
    void release() {}
    void acquire() {}
#endif

    Call call_;
};

} // namespace usar
