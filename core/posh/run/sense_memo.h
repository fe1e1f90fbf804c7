// Evaluates senses and caches their answers within an epoch.
#pragma once

#include <vector>

#include "core/posh/run/tracer.h"

namespace usar::posh {

/// Asks the host for each call at most once per epoch, regardless of how many places need it. Answers the built-in
/// senses (such as `succeed` and `fail`) itself, unless the host has a sense of that name.
class SenseMemo {
public:
    /// All three must outlive this object.
    SenseMemo(Host& host, const Tracer& tracer, Profiler& profiler)
        : host_(host)
        , tracer_(tracer)
        , profiler_(profiler) {}

    /// Forgets everything and reserves all memory that a run needs.
    void load();
    /// Makes all cached answers invalid.
    void beginEpoch() { ++epoch_; }

    /// Returns whether all tests of a range hold; true for an empty one. Evaluates them from left to right and stops at
    /// the first that does not hold.
    bool allHold(Range tests) {
        for (Index test = tests.first; test != tests.end; ++test)
            if (!holds(test))
                return false;
        return true;
    }
    /// Evaluates one test and traces it. A sense that throws does not hold.
    bool holds(Index test);

private:
    enum class Builtin : std::uint8_t { None, True, False };
    struct Answer {
        std::uint64_t epoch = 0; ///< the epoch in which it was given
        Value value;
        bool failed = false; ///< whether the host threw an exception
        Builtin builtin = Builtin::None;
    };
    static Builtin builtinOf(std::string_view name);
    void ask(const ProgramTest& test, Answer& answer);
    bool verdict(Index index, const ProgramTest& test, const Answer& answer);

    Host& host_;
    const Tracer& tracer_;
    Profiler& profiler_;
    std::uint64_t epoch_ = 0;
    std::vector<Answer> answers_; ///< indexed by sense call
    std::vector<char> warned_;    ///< for each test: whether it has warned of types without an order
};

} // namespace usar::posh
