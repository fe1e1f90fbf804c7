#include "core/agent/shared_processor.h"

#include <algorithm>

#include <time.h>

namespace usar::agent {

namespace {

/// Between two looks at the clocks, which is time enough for a judgment.
constexpr Seconds look_period{0.02};
constexpr int turns_before_clock = 16; ///< To ask the clocks at each turn would cost a hundredth of the turn.

Seconds read(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return Seconds(static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec));
}

} // namespace

bool SharingRule::shouldShare(Seconds passed, Seconds worked) {
    constexpr double undisturbed = 0.85; // Alone on a processor, two threads at full speed leave it hardly any rest.
    constexpr double busy = 0.4;         // Below, they mostly wait for something else: nothing is to be gained.
    constexpr Seconds longest_pause{3.2};
    if (shares_) {
        shares_ = worked >= undisturbed * passed;
        if (shares_) {
            next_pause_ = shortest_pause;
        } else {
            pause_ = next_pause_;
            next_pause_ = std::min(2.0 * next_pause_, longest_pause);
        }
        return shares_;
    }
    pause_ -= passed;
    shares_ = pause_ <= Seconds{0.0} && worked >= busy * passed;
    return shares_;
}

OneProcessor::OneProcessor(pthread_t other) : other_(other) {
    const int here = sched_getcpu();
    if (here < 0 || here >= CPU_SETSIZE || pthread_getaffinity_np(caller_, sizeof before_, &before_) != 0)
        return;
    bound_ = true;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(here, &only);
    allow(only);
}

OneProcessor::~OneProcessor() {
    if (bound_)
        allow(before_);
}

void OneProcessor::allow(const cpu_set_t& processors) const {
    pthread_setaffinity_np(caller_, sizeof processors, &processors);
    pthread_setaffinity_np(other_, sizeof processors, &processors);
}

SharedProcessor::Times SharedProcessor::times() const {
    Seconds worked = read(CLOCK_THREAD_CPUTIME_ID);
    if (clockid_t others{}; pthread_getcpuclockid(other_, &others) == 0)
        worked += read(others);
    return {read(CLOCK_MONOTONIC), worked};
}

void SharedProcessor::turn() {
    if (++turns_ % turns_before_clock != 0)
        return;
    if (last_look_ && read(CLOCK_MONOTONIC) - last_look_->wall < look_period)
        return;
    const Times now = times();
    if (last_look_) {
        const bool share = rule_.shouldShare(now.wall - last_look_->wall, now.worked - last_look_->worked);
        if (!share)
            shared_.reset();
        else if (!shared_)
            shared_.emplace(other_);
    }
    last_look_ = now;
}

} // namespace usar::agent
