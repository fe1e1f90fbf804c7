// What it costs to read and write POSH plans: one of 3,000 elements, and one of 1,000 lines as it is read again at each
// keystroke; beside a reader of the usual make (words into a tree of lists of strings, nothing checked).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"

namespace {

using namespace usar::posh;

constexpr int elements_each = 10;

/// Competences of ten elements each, one line an element, and a drive for each competence; sound and without warnings.
std::string planOf(int elements) {
    std::string forms;
    std::string drives;
    for (int c = 0; c < elements / elements_each; ++c) {
        const std::string number = std::to_string(c);
        forms +=
            "  (C search-" + number + " vars($speed=0.5) (minutes 2) (goal ((found-" + number + ")))\n    (elements\n";
        for (int e = 0; e < elements_each; ++e)
            forms += "      ((step-" + std::to_string(e) +
                     " (trigger ((distance-left 0.30 <) (blocked false))) drive-to($speed, " + std::to_string(e) +
                     ") 3))  ; near\n";
        forms += "    ))\n";
        drives += "      ((watch-" + number + " (trigger ((asked " + number + "))) search-" + number +
                  "(1.5) (seconds 1)))\n";
    }
    return "(\n" + forms + "  (DC robot (goal ((done)))\n    (drives\n" + drives + "    ))\n)\n";
}

/// Of a plan with about so many lines.
std::string planOfLines(int lines) {
    return planOf(lines * elements_each / (elements_each + 4));
}

struct List {
    std::string word;
    std::vector<std::unique_ptr<List>> members;
};

/// As most readers of such languages do it.
std::unique_ptr<List> readLists(std::string_view text) {
    auto root = std::make_unique<List>();
    std::vector<List*> open{root.get()};
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == ';') {
            at = text.find('\n', at);
        } else if (c == '(') {
            open.back()->members.push_back(std::make_unique<List>());
            open.push_back(open.back()->members.back().get());
            ++at;
        } else if (c == ')') {
            open.pop_back();
            ++at;
        } else if (usar::isSpace(c)) {
            ++at;
        } else {
            const std::size_t end = std::min(text.find_first_of("() \t\n;", at), text.size());
            open.back()->members.push_back(std::make_unique<List>());
            open.back()->members.back()->word = text.substr(at, end - at);
            at = end;
        }
    }
    return root;
}

void setRates(benchmark::State& state, const std::string& text) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
    state.counters["lines"] = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
}

template <class Read>
void readAgain(benchmark::State& state, const std::string& text, Read&& read) {
    for (auto _ : state)
        benchmark::DoNotOptimize(read(text));
    setRates(state, text);
}

void readPlanOf3000Elements(benchmark::State& state) {
    readAgain(state, planOf(3000), [](const std::string& text) { return readPlan(text); });
}
BENCHMARK(readPlanOf3000Elements)->Unit(benchmark::kMillisecond);

void readListsOf3000Elements(benchmark::State& state) {
    readAgain(state, planOf(3000), [](const std::string& text) { return readLists(text); });
}
BENCHMARK(readListsOf3000Elements)->Unit(benchmark::kMillisecond);

void readPlanOf1000Lines(benchmark::State& state) {
    readAgain(state, planOfLines(1000), [](const std::string& text) { return readPlan(text); });
}
BENCHMARK(readPlanOf1000Lines)->Unit(benchmark::kMillisecond);

void readListsOf1000Lines(benchmark::State& state) {
    readAgain(state, planOfLines(1000), [](const std::string& text) { return readLists(text); });
}
BENCHMARK(readListsOf1000Lines)->Unit(benchmark::kMillisecond);

void writePlanOf3000Elements(benchmark::State& state) {
    const Plan plan = readPlan(planOf(3000)).plan;
    for (auto _ : state)
        benchmark::DoNotOptimize(writePlan(plan));
    setRates(state, planOf(3000));
}
BENCHMARK(writePlanOf3000Elements)->Unit(benchmark::kMillisecond);

/// One action renamed, all else as it was.
void keepLayoutOf3000Elements(benchmark::State& state) {
    const std::string text = planOf(3000);
    Plan plan = readPlan(text).plan;
    std::get<Competence>(plan.forms[100]).levels[5][0].action.name.text = "drive-away";
    for (auto _ : state)
        benchmark::DoNotOptimize(writeKeepingLayout(text, plan));
    setRates(state, text);
}
BENCHMARK(keepLayoutOf3000Elements)->Unit(benchmark::kMillisecond);

} // namespace
