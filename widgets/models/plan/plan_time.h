// The moment of a run that a plan view shows.
#pragma once

#include <cstdint>

#include "core/base/clock.h"

namespace usar::widgets {

/// All times are on the protocol clock.
struct PlanTime {
    Seconds begin{0.0};      ///< start of the run
    Seconds end{0.0};        ///< newest moment known
    Seconds shown{0.0};      ///< the moment that is displayed
    std::uint64_t cycle = 0; ///< number of the cycle shown; 0: none
    std::size_t epoch = 0;   ///< epoch shown within the cycle, from 1; 0: the whole cycle
    std::size_t epochs = 1;  ///< number of epochs in the cycle
    bool live = true;        ///< follows the run
    bool replay = false;     ///< the run is a recording
    bool operator==(const PlanTime&) const = default;
};

} // namespace usar::widgets
