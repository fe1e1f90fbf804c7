#include "core/posh/trace/run_report.h"

#include <algorithm>
#include <array>

namespace usar::posh {

namespace {

std::string times(std::uint64_t count) {
    return std::to_string(count) + (count == 1 ? " time" : " times");
}

class Reporter {
public:
    explicit Reporter(const RunStatistics& statistics) : statistics_(statistics), program_(*statistics.program()) {}

    std::vector<RunFinding> report() {
        if (statistics_.cycles() == 0)
            return {};
        for (Index place = 0; place < program_.places.size(); ++place)
            look(place);
        for (const auto& [drives, alternation] : statistics_.alternations())
            if (alternation.most > most_switches)
                say(RunRemark::Oscillation, drives.first,
                    "and " + nameOf(program_, drives.second) + " switched " +
                        times(static_cast<std::uint64_t>(alternation.most)) + " within ten seconds, up to cycle " +
                        std::to_string(alternation.cycle));
        for (const auto& [drive, count] : statistics_.starved())
            say(RunRemark::Starving, drive, "won and found nothing to do, ten cycles in a row, " + times(count));
        for (const auto& [drive, count] : statistics_.spun())
            say(RunRemark::Spinning, drive, "used up the budget of acts " + times(count));
        std::ranges::stable_sort(findings_, {}, &RunFinding::place);
        return std::move(findings_);
    }

private:
    void look(Index place) {
        const PlaceCounts& counts = statistics_.at(place);
        const Place& here = program_.places[place];
        if (here.kind == PlaceKind::Drive && counts.started == 0)
            say(RunRemark::NeverSelected, place,
                "never started in " + std::to_string(statistics_.cycles()) + " cycles");
        else if (here.kind == PlaceKind::Element && counts.started == 0 && statistics_.at(here.parent).started > 0)
            say(RunRemark::NeverSelected, place,
                "was never selected, though its competence was entered " + times(statistics_.at(here.parent).started));
        else if (here.kind == PlaceKind::Sense || here.kind == PlaceKind::SenseStep)
            lookAtSense(place, counts);
    }

    void lookAtSense(Index place, const PlaceCounts& counts) {
        const std::string& name = program_.sense_calls[program_.tests[program_.places[place].item].call].name;
        const bool by_name = name == "succeed" || name == "fail" || name == "true" || name == "false";
        if (by_name)
            return; // These always give the same answer on purpose
        if (counts.asked > 0 && counts.held == 0)
            say(RunRemark::NeverTrue, place, "was asked " + times(counts.asked) + " and never held");
        else if (counts.asked >= often_asked && counts.held == counts.asked)
            say(RunRemark::AlwaysTrue, place, "was asked " + times(counts.asked) + " and always held");
    }

    void say(RunRemark remark, Index place, const std::string& what) {
        findings_.push_back({remark, place, namePathOf(program_, place) + " " + what});
    }

    const RunStatistics& statistics_;
    const Program& program_;
    std::vector<RunFinding> findings_;
};

} // namespace

std::string_view toText(RunRemark remark) {
    constexpr std::array<std::string_view, 6> words{"never-selected", "never-true", "always-true",
                                                    "oscillation",    "starving",   "spinning"};
    return words[static_cast<std::size_t>(remark)];
}

std::vector<RunFinding> reportOn(const RunStatistics& statistics) {
    return Reporter(statistics).report();
}

} // namespace usar::posh
