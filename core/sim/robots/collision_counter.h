// Counts collisions: touches in close succession count as one.
#pragma once

#include "core/base/clock.h"

namespace usar::sim {

class CollisionCounter {
public:
    /// Touches no more than this apart are one collision.
    static constexpr Seconds apart{0.5};

    /// Lets time pass, to be called at each step.
    void pass(Seconds dt) { since_ += dt; }
    /// Takes a touch, several times per step if need be.
    void touch() {
        count_ += since_ > apart ? 1 : 0;
        since_ = Seconds{0.0};
    }
    int count() const { return count_; }

private:
    Seconds since_{1e9};
    int count_ = 0;
};

} // namespace usar::sim
