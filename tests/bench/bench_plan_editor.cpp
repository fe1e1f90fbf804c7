// What a keystroke costs in the editor of plans: the text read and checked again, its errors marked, the drawing made
// anew.
#include <string>

#include <benchmark/benchmark.h>

#include "tests/bench/bench_application.h"
#include "widgets/plan/editor/plan_editor.h"

using namespace usar;

namespace {

/// One element a line, and a drive for each ten of them.
std::string searchPlanOfLines(int lines) {
    std::string forms;
    std::string drives;
    for (int c = 0; c < lines / 14; ++c) {
        const std::string number = std::to_string(c);
        forms += "  (C search-" + number + " (goal ((Found " + number + ")))\n    (elements\n";
        for (int e = 0; e < 10; ++e)
            forms += "      ((step-" + std::to_string(e) + " (trigger ((Distance 0.30 <) (Blocked false))) DriveTo(" +
                     std::to_string(e) + ") 3))\n";
        forms += "    ))\n";
        drives += "      ((watch-" + number + " (trigger ((Asked " + number + "))) search-" + number + "))\n";
    }
    return "(\n" + forms + "  (DC robot (goal ((Found)))\n    (drives\n" + drives + "    ))\n)\n";
}

std::vector<agent::PrimitiveDescription> primitives() {
    using agent::AnswerType;
    using agent::PrimitiveKind;
    return {
        {"Found", PrimitiveKind::Sense, {}, AnswerType::Any, {}, {}, {}},
        {"Distance", PrimitiveKind::Sense, {}, AnswerType::Real, "m", {}, {}},
        {"Blocked", PrimitiveKind::Sense, {}, AnswerType::Boolean, {}, {}, {}},
        {"Asked", PrimitiveKind::Sense, {}, AnswerType::Integer, {}, {}, {}},
        {"DriveTo", PrimitiveKind::Act, {agent::PoshParameter::whole("place", 0, 0, 99)}, AnswerType::Any, {}, {}, {}}};
}

/// `drawn` 0: until the errors are marked; 1: until the drawing is new as well.
void keystroke(benchmark::State& state) {
    bench::needApplication();
    widgets::PlanEditor editor;
    editor.resize(1280, 720);
    editor.setPrimitives(primitives());
    editor.setText(searchPlanOfLines(static_cast<int>(state.range(0))), "large.lap");
    editor.show();
    const auto middle = editor.text().find("step-5");
    QTextCursor cursor = editor.textEdit().textCursor();
    cursor.setPosition(static_cast<int>(middle));
    editor.textEdit().setTextCursor(cursor);
    bool typed = false;
    for ([[maybe_unused]] auto _ : state) {
        if (typed)
            editor.textEdit().textCursor().deletePreviousChar();
        else
            editor.textEdit().textCursor().insertText(QStringLiteral("x"));
        typed = !typed;
        if (state.range(1) != 0)
            editor.catchUp();
        else
            benchmark::DoNotOptimize(editor.findings().size());
    }
    state.counters["lines"] = static_cast<double>(editor.textEdit().blockCount());
}
BENCHMARK(keystroke)
    ->Name("a keystroke in a plan, lines / drawn")
    ->Args({1000, 0})
    ->Args({1000, 1})
    ->Unit(benchmark::kMillisecond);

} // namespace
