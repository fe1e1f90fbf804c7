// Random numbers from an engine that the caller passes in. Equal seeds give equal numbers within one build.
#pragma once

#include <cstdint>
#include <random>

namespace usar {

using Random = std::mt19937_64;

/// Returns the engine number `stream` of a seed. Each consumer uses its own stream, so that adding a sensor does not
/// change the noise of another.
inline Random seeded(std::uint64_t seed, std::uint64_t stream) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)};
    return Random(sequence);
}

/// A normally distributed number with mean 0 and standard deviation `sigma`.
inline double gaussian(Random& random, double sigma) {
    return std::normal_distribution<double>(0.0, sigma)(random);
}

/// A uniformly distributed number in [low, high).
inline double uniform(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

} // namespace usar
