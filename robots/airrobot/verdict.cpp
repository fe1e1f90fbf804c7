#include "robots/airrobot/verdict.h"

#include <cmath>
#include <string>

#include "core/base/numbers.h"

namespace usar::airrobot {

namespace {

constexpr double most_cut_off = 0.99; ///< share of the lanes
/// Share of the time on the lanes in which the map must get scans. In gusts, more than half of them may be no good;
/// where fewer come through, lines were lost, and the map has gaps.
constexpr double least_mapped = 0.2;
/// Share of the area that the scans must show, of as much of it as the lanes were flown over. Houses and crowns hide
/// some.
constexpr double least_looked_at = 0.8;
constexpr double mostly_looked_at = 0.95; ///< If they show less than this, a success says so.
/// Share of the ground within reach of which a survey may miss so much without a word, and so much in a success.
constexpr double little_missed = 0.03;
constexpr double most_missed = 0.1;
constexpr double little_void = 0.03; ///< of the area
constexpr double least_seen = 0.05;  ///< the same for ground on the map

agent::BehaviorFinished failed(const std::string& reason) {
    return {false, reason};
}

std::string rounded(double number) {
    return std::to_string(std::lround(number));
}

} // namespace

agent::BehaviorFinished verdictOf(const Survey& survey, const ScanLedger& ledger, const Settings& settings,
                                  double missed) {
    const double cut_off_m = survey.cutOff_m();
    if (cut_off_m > most_cut_off * survey.plannedLength_m())
        return failed("No way was found into the area.");
    if (ledger.mapped() < least_mapped)
        return failed("The lanes were flown, but few scans of them came and show ground. Is the area in the world, and "
                      "are no lines lost on the way?");
    const std::string goals = "goals left out: " + std::to_string(survey.goalsGivenUp()) + ", " +
                              rounded(survey.givenUp_pct()) + " % of the lanes";
    if (survey.givenUp_pct() > settings.most_left_out_pct)
        return failed("The area is not scanned; " + goals + ", and at most " + rounded(settings.most_left_out_pct) +
                      " % may be. Raise the time until a goal is given up, or choose an area with room to fly.");
    if (ledger.seen() < least_seen * (1.0 - survey.leftOut()))
        return failed("The lanes were flown, but there is hardly any ground within the scanner's reach. Is the area in "
                      "the world?");
    const double looked_at = ledger.seen() + ledger.bottomless();
    if (looked_at < least_looked_at * (1.0 - survey.leftOut()))
        return failed("The lanes were flown, but the scans show only " + rounded(100.0 * looked_at) +
                      " % of the area. Are lines lost on the way, or does something hide the rest?");
    if (missed > most_missed)
        return failed("The lanes were flown, but no scan shows " + rounded(100.0 * missed) +
                      " % of the ground that the robot could have reached. Lanes that are nearer to one another show "
                      "more.");
    std::string scanned = settings.navigate_by_truth ? "The area is scanned by ground truth" : "The area is scanned";
    if (cut_off_m > 0.0)
        scanned += " as far as a way was found; none was found to " + fixed(cut_off_m, 0) + " m of the lanes (" +
                   fixed(100.0 * cut_off_m / survey.plannedLength_m(), 0) + " %)";
    if (looked_at < mostly_looked_at * (1.0 - survey.leftOut()))
        scanned += "; the scans show " + rounded(100.0 * looked_at) + " % of it";
    if (ledger.bottomless() > little_void)
        scanned += "; below " + rounded(100.0 * ledger.bottomless()) + " % of it, no ground is within reach";
    if (missed > little_missed)
        scanned += "; no scan shows " + rounded(100.0 * missed) + " % of the ground within reach";
    return {true, scanned + (survey.goalsGivenUp() == 0 ? "." : "; " + goals + ".")};
}

std::string placeWords(const Vec2& at_m) {
    return "x " + fixed(at_m.x(), 1) + " m, y " + fixed(at_m.y(), 1) + " m";
}

} // namespace usar::airrobot
