#include "core/campaign/plan/swarm.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace usar::campaign {

namespace {

constexpr double longest_s = 60.0;

/// Tenths of a second are enough, and read well in a command.
std::string time(double time_s) {
    return fixed(time_s, 1);
}

std::string strength(const FaultRange& range, Random& random) {
    const double nearest = range.usual == 0.0 ? std::min(1.0, range.most) : range.usual;
    const double drawn =
        range.whole ? std::floor(uniform(random, range.least, range.most + 1.0)) : uniform(random, 0.5, 2.0) * nearest;
    return ' ' + range.name + '=' + fixed(std::clamp(drawn, range.least, range.most), range.whole ? 0 : 3);
}

/// Some of the numbers, but at least one: some kinds of faults do nothing by themselves.
std::string strengths(const std::vector<FaultRange>& numbers, Random& random) {
    std::string text;
    for (const FaultRange& range : numbers)
        if (uniform(random, 0.0, 1.0) < 0.5)
            text += strength(range, random);
    return text.empty() && !numbers.empty() ? strength(numbers.front(), random) : text;
}

} // namespace

std::vector<std::string> drawFaults(const Swarm& swarm, std::span<const FaultChoice> choices, Random& random) {
    std::vector<std::string> faults;
    for (const FaultChoice& choice : choices) {
        const bool wanted = swarm.kinds.empty() || std::ranges::find(swarm.kinds, choice.word) != swarm.kinds.end();
        if (!wanted || uniform(random, 0.0, 1.0) >= swarm.share)
            continue;
        std::string fault = choice.word + strengths(choice.numbers, random);
        fault += " from=" + time(uniform(random, swarm.least_s, swarm.most_s));
        if (uniform(random, 0.0, 1.0) < 0.5)
            fault += " for=" + time(uniform(random, 1.0, longest_s));
        faults.push_back(std::move(fault));
    }
    return faults;
}

} // namespace usar::campaign
