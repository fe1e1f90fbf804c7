// The priority of a thread, for work that may wait.
#pragma once

namespace usar {

/// From now on the calling thread, and the threads that it starts, get the processor after those of the program's usual
/// priority that want it, too. It cannot be taken back. QThread::setPriority has no effect with Linux's usual
/// scheduling.
void yieldToOthers();

} // namespace usar
