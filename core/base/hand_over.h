// A function call that one thread prepares and another thread executes.
#pragma once

#include <type_traits>
#include <utility>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace usar {

/// States an order that ThreadSanitizer cannot see: what one thread wrote before `happensBefore(mark)` happens before
/// what another does after `happensAfter(mark)` with the same mark. Nothing without ThreadSanitizer.
#ifdef __SANITIZE_THREAD__
inline void happensBefore(const void* mark) {
    __tsan_release(const_cast<void*>(mark));
}
inline void happensAfter(const void* mark) {
    __tsan_acquire(const_cast<void*>(mark));
}
#else
inline void happensBefore(const void*) {}
inline void happensAfter(const void*) {}
#endif

/// Wraps a callable so that ThreadSanitizer sees the handover. Debian's Qt is not built for ThreadSanitizer, which
/// therefore does not know that an event is posted before it is delivered and reports every value in it as a race. This
/// wrapper states the order: everything written before the wrapper was constructed at its current address happens
/// before the call, and everything written by the call happens before the wrapper is destroyed. Without ThreadSanitizer
/// it adds nothing to the callable.
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

    /// Runs the callable; called in the receiving thread.
    void operator()() {
        acquire();
        call_();
        release();
    }

private:
    void release() { happensBefore(this); }
    void acquire() { happensAfter(this); }

    Call call_;
};

} // namespace usar
