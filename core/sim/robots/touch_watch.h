// When a robot touched a thing that can be pushed, and how often.
#pragma once

#include <optional>

#include "core/sim/robots/collision_counter.h"

namespace usar::sim {

/// Time counts from the spawn.
class TouchWatch {
public:
    void pass(Seconds dt) {
        now_ += dt;
        touches_.pass(dt);
    }
    void touch() {
        touches_.touch();
        if (!first_)
            first_ = now_;
    }
    /// Those that follow one another closely are one.
    int count() const { return touches_.count(); }
    std::optional<Seconds> first() const { return first_; }

private:
    Seconds now_{0.0};
    CollisionCounter touches_;
    std::optional<Seconds> first_;
};

} // namespace usar::sim
