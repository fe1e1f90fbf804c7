// How long the code of a plugin may take before it counts as hanging.
#pragma once

#include "core/base/clock.h"

namespace usar::agent {

/// Limits in wall time. After them a process of its own is killed, and a thread of this program is left behind. Tests
/// shorten them.
struct Patience {
    Seconds answer{1.0};             ///< a behavior's answer to a line, an order, or a change of its plan
    Seconds answer_in_lockstep{5.0}; ///< the same if the server's time waits for the answer
    Seconds making{15.0};            ///< starting a process for a behavior, loading the plugin in it, and creating it
    Seconds loading{5.0};            ///< starting a process for a plugin, loading it there, and its description
    Seconds preview{1.0};            ///< computing a preview in such a process
    Seconds end{0.5};                ///< the end of such a process after the connection was closed
};

} // namespace usar::agent
