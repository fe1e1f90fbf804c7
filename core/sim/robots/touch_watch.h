// When a robot first touched an object or another robot, and how often it did.
#pragma once

#include <optional>

#include "core/sim/robots/collision_counter.h"

namespace usar::sim {

/// Time counts from the spawn.
class TouchWatch {
public:
    /// Lets time pass, to be called at each step.
    void pass(Seconds dt) {
        now_ += dt;
        touches_.pass(dt);
    }
    void touch() {
        touches_.touch();
        if (!first_)
            first_ = now_;
    }
    /// Touches in close succession count as one; see CollisionCounter.
    int count() const { return touches_.count(); }
    /// Time of the first touch; nullopt before it.
    std::optional<Seconds> first() const { return first_; }

private:
    Seconds now_{0.0};
    CollisionCounter touches_;
    std::optional<Seconds> first_;
};

} // namespace usar::sim
