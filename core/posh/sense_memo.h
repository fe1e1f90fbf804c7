// Asks senses: each call once per epoch, whatever number of places asks for it.
#pragma once

#include <vector>

#include "core/posh/profiler.h"
#include "core/posh/tracer.h"

namespace usar::posh {

class SenseMemo {
public:
    SenseMemo(Host& host, const Tracer& tracer, Profiler& profiler)
        : host_(host)
        , tracer_(tracer)
        , profiler_(profiler) {}

    /// Forgets everything; takes up all memory that a run will need.
    void load(const Program& program);
    /// Keeps what it knows; the program has the same shape.
    void retune(const Program& program) { program_ = &program; }
    /// Forgets all answers.
    void beginEpoch() { ++epoch_; }

    /// Whether all of them hold, asked from left to right up to the first that does not. True for none.
    bool allHold(Range tests) {
        for (Index test = tests.first; test != tests.end; ++test)
            if (!holds(test))
                return false;
        return true;
    }
    bool holds(Index test);

private:
    enum class Builtin : std::uint8_t { None, True, False };
    struct Answer {
        std::uint64_t epoch = 0;
        Value value;
        bool failed = false; ///< the host threw
        Builtin builtin = Builtin::None;
    };
    static Builtin builtinOf(std::string_view name);
    void ask(const ProgramTest& test, Answer& answer);
    bool verdict(Index index, const ProgramTest& test, const Answer& answer);

    Host& host_;
    const Tracer& tracer_;
    Profiler& profiler_;
    const Program* program_ = nullptr;
    std::uint64_t epoch_ = 0;
    std::vector<Answer> answers_; ///< by sense call
    std::vector<char> warned_;    ///< by test: of unlike types, once
};

} // namespace usar::posh
