// How one thread waits for what another one does.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "core/base/clock.h"

namespace usar::agent {

/// One thread waits here until a condition holds, and another one rings after it has changed what the condition reads,
/// which are atomics in their usual, sequentially consistent order. Uses no semaphores and no waiting atomics, because
/// those of the standard library yield before they sleep, which costs milliseconds on a busy machine. To stay awake for
/// a moment costs half of the speed there.
class Doorbell {
public:
    /// Wakes the waiting thread if it sleeps.
    void ring() {
        if (!asleep_)
            return;
        { const std::lock_guard until_it_sleeps(mutex_); }
        rung_.notify_one();
    }

    /// Returns when `holds` does: true; false if it does not within the patience. For the waiting thread.
    template <class Condition>
    bool wait(const Condition& holds, Seconds patience) {
        if (holds())
            return true;
        std::unique_lock lock(mutex_);
        asleep_ = true;
        const bool held = rung_.wait_for(lock, patience, holds);
        asleep_ = false;
        return held;
    }

private:
    std::mutex mutex_;
    std::condition_variable rung_;
    std::atomic<bool> asleep_ = false;
};

} // namespace usar::agent
