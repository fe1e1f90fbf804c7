#include "core/posh/run/sense_memo.h"

#include "core/posh/run/comparison.h"

namespace usar::posh {

void SenseMemo::load() {
    const Program& program = *tracer_.program();
    answers_.assign(program.sense_calls.size(), {});
    warned_.assign(program.tests.size(), 0);
    for (std::size_t i = 0; i < answers_.size(); ++i)
        if (!host_.hasSense(program.sense_calls[i].name))
            answers_[i].builtin = builtinOf(program.sense_calls[i].name);
}

SenseMemo::Builtin SenseMemo::builtinOf(std::string_view name) {
    constexpr std::string_view executor = "cz.cuni.amis.pogamut.sposh.executor.";
    if (name.starts_with(executor))
        name.remove_prefix(executor.size());
    if (name == "succeed" || name == "true" || name == "Succeed")
        return Builtin::True;
    return name == "fail" || name == "false" || name == "Fail" ? Builtin::False : Builtin::None;
}

bool SenseMemo::holds(Index index) {
    const ProgramTest& test = tracer_.program()->tests[index];
    Answer& answer = answers_[test.call];
    const bool cached = answer.epoch == epoch_;
    if (!cached)
        ask(test, answer);
    const bool holds = verdict(index, test, answer);
    tracer_.noteSense(test.place, answer.value, holds, cached);
    return holds;
}

void SenseMemo::ask(const ProgramTest& test, Answer& answer) {
    answer.epoch = epoch_;
    answer.failed = false;
    if (answer.builtin != Builtin::None) {
        answer.value = answer.builtin == Builtin::True;
        return;
    }
    answer.value = std::monostate{};
    answer.failed = !profiler_.call(test.place, [&] { host_.sense({test.call, test.place}, answer.value); });
    if (answer.failed)
        answer.value = std::monostate{};
}

bool SenseMemo::verdict(Index index, const ProgramTest& test, const Answer& answer) {
    if (answer.failed)
        return false;
    if (!test.compares)
        return truthOf(answer.value);
    const Comparison comparison = compare(answer.value, test.predicate, test.operand);
    if (comparison == Comparison::Unlike && !warned_[index]) {
        warned_[index] = 1;
        tracer_.warn(WarningCode::UnlikeTypes, test.place, "answer and operand have no order: the sense never holds");
    }
    return comparison == Comparison::Holds;
}

} // namespace usar::posh
