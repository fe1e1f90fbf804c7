// How time goes on for the toys.
#pragma once

namespace usar::test {

inline constexpr double tick_s = 0.2; ///< between two states, as USARSim's robots speak
inline constexpr int substeps = 10;   ///< how often their motion is computed in each tick

} // namespace usar::test
