#include "core/base/thread_priority.h"

#include <algorithm>

#include <sys/resource.h>
#include <unistd.h>

namespace usar {

void yieldToOthers() {
    // Linux has a nice value for each thread: the process's number is that of its first thread, 0 the calling one. A
    // failure leaves the usual priority.
    constexpr int more = 10, most = 19;
    const int usual = getpriority(PRIO_PROCESS, static_cast<id_t>(getpid()));
    setpriority(PRIO_PROCESS, 0, std::min(usual + more, most));
}

} // namespace usar
