// Randomness is an engine that is handed in; equal seeds give equal numbers on one build.
#pragma once

#include <cstdint>
#include <random>

namespace usar {

using Random = std::mt19937_64;

/// An engine of its own for each consumer, so that adding a sensor does not change another one's noise.
inline Random seeded(std::uint64_t seed, std::uint64_t stream) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)};
    return Random(sequence);
}

inline double gaussian(Random& random, double sigma) {
    return std::normal_distribution<double>(0.0, sigma)(random);
}

inline double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

} // namespace usar
