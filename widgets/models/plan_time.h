// Where the shown state of a plan stands in its run.
#pragma once

#include <cstdint>

#include "core/base/clock.h"

namespace usar::widgets {

/// Times are those of the protocol.
struct PlanTime {
    Seconds begin{0.0}; ///< of the run
    Seconds end{0.0};   ///< the newest that is known
    Seconds shown{0.0};
    std::uint64_t cycle = 0; ///< that is shown; 0: there is none
    std::size_t epoch = 0;   ///< within it, from 1; 0: all of it
    std::size_t epochs = 1;  ///< it has
    bool live = true;        ///< follows the run
    bool replay = false;     ///< of a recording
    bool operator==(const PlanTime&) const = default;
};

} // namespace usar::widgets
