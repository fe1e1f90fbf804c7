#include "core/base/thread_priority.h"

#include <sys/resource.h>

namespace usar {

void yieldToOthers() {
    // Linux takes 0 for the calling thread rather than for the whole process. A failure leaves the usual priority.
    constexpr int nice = 10;
    setpriority(PRIO_PROCESS, 0, nice);
}

} // namespace usar
