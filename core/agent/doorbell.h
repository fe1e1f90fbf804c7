// How one thread waits for what another one does.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/base/clock.h"

namespace usar::agent {

/// One thread waits here until a condition holds, and another one rings after it has changed what the condition reads,
/// which are atomics in their usual, sequentially consistent order. Uses no semaphores and no waiting atomics, because
/// those of the standard library yield before they sleep, which costs milliseconds on a busy machine.
class Doorbell {
public:
    /// `awake`: the thread looks again and again for a moment before it sleeps, because being woken up takes longer
    /// than what it waits for. That needs a second processor, and is given up while the waits are longer than that.
    explicit Doorbell(bool awake) : awake_(awake && std::thread::hardware_concurrency() > 1) {}

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
        const Clock::time_point began = Clock::now();
        if (awake_ && worthIt() && holdsSoon(holds, began))
            return true;
        bool held = false;
        {
            std::unique_lock lock(mutex_);
            asleep_ = true;
            held = rung_.wait_for(lock, patience, holds);
            asleep_ = false;
        }
        note(Clock::now() - began);
        return held;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::microseconds longest_awake{300};
    static constexpr int most_late = 16;

    bool worthIt() const { return late_ < most_late / 2; }
    void note(Clock::duration waited) {
        late_ = waited > longest_awake ? std::min(late_ + 1, most_late) : std::max(late_ - 1, 0);
    }

    template <class Condition>
    bool holdsSoon(const Condition& holds, Clock::time_point began) {
        constexpr int looks = 32; // Between two looks at the clock.
        do {
            for (int i = 0; i < looks; ++i) {
                if (holds()) {
                    note({});
                    return true;
                }
                pause();
            }
        } while (Clock::now() - began < longest_awake);
        return false;
    }

    /// Tells the processor that this is a loop that waits, so that it saves power and leaves room for its twin.
    static void pause() {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#elif defined(__aarch64__)
        asm volatile("yield");
#endif
    }

    const bool awake_;
    std::mutex mutex_;
    std::condition_variable rung_;
    std::atomic<bool> asleep_ = false;
    int late_ = 0; ///< grows with waits that were too long to stay awake for, and shrinks with others
};

} // namespace usar::agent
