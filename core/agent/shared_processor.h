// Keeps two threads that work in turn on one processor.
#pragma once

#include <optional>

#include <pthread.h>
#include <sched.h>

#include "core/base/clock.h"

namespace usar::agent {

/// Says whether two threads that work in turn should share one processor. To wake up another one takes tens of
/// microseconds in a virtual machine, longer than most turns, and the system, which does not know of turns, gives each
/// thread a processor of its own as long as one is idle. Where others want the processor, too, the two are better off
/// without that, so the rule goes by how much they get to work, and tries again later and later.
class SharingRule {
public:
    /// Call it now and then. `worked`: the processor time that both threads had together within the last `passed` of
    /// wall time, of which one alone cannot have more. Returns whether they should share from now on.
    bool shouldShare(Seconds passed, Seconds worked);

private:
    static constexpr Seconds shortest_pause{0.1};

    bool shares_ = false;
    Seconds pause_{0.0};                  ///< until the next try
    Seconds next_pause_ = shortest_pause; ///< after the next failure
};

/// Binds two threads to the processor on which the calling one runs; the end of this object lets them run where they
/// might before.
class OneProcessor {
public:
    /// For the calling thread and another one that outlives this object. Where the system refuses, they stay as they
    /// are.
    explicit OneProcessor(pthread_t other);
    ~OneProcessor();
    OneProcessor(const OneProcessor&) = delete;
    OneProcessor& operator=(const OneProcessor&) = delete;

private:
    void allow(const cpu_set_t& processors) const;

    pthread_t caller_ = pthread_self();
    pthread_t other_;
    cpu_set_t before_{};
    bool bound_ = false;
};

/// Applies the rule to the calling thread and another one, which must outlive this object. All calls are made in the
/// thread of the first.
class SharedProcessor {
public:
    explicit SharedProcessor(pthread_t other) : other_(other) {}
    /// Tells that a turn has begun.
    void turn();

private:
    struct Times {
        Seconds wall, worked;
    };
    Times times() const;

    pthread_t other_;
    SharingRule rule_;
    std::optional<Times> last_look_;
    std::optional<OneProcessor> shared_;
    int turns_ = 0;
};

} // namespace usar::agent
