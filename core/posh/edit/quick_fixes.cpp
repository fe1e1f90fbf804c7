#include "core/posh/edit/quick_fixes.h"

#include <algorithm>

#include "core/posh/edit/fix_finder.h"
#include "core/posh/language/plan_reader.h"

namespace usar::posh {

namespace {

constexpr std::size_t most_fixes = 8;

struct Count {
    long unreadable = 0;
    long errors = 0;
    long same = 0; ///< findings with the same code and message as the wanted one
};

Count count(const Findings& findings, const Finding& wanted) {
    Count counted;
    for (const Finding& finding : findings) {
        counted.unreadable += isUnreadable(finding.code) ? 1 : 0;
        counted.errors += severityOf(finding.code) == Severity::Error ? 1 : 0;
        counted.same += finding.code == wanted.code && finding.message == wanted.message ? 1 : 0;
    }
    return counted;
}

/// Returns whether a fix helps. If it makes a form readable again, that form may have errors of its own, which do not
/// count because they existed before.
bool helps(const Count& before, const Count& after, const Finding& finding) {
    if (after.same >= before.same || after.unreadable > before.unreadable)
        return false;
    return isUnreadable(finding.code) || after.errors <= before.errors;
}

bool isInsideCharacter(std::string_view text, std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
}

} // namespace

std::string withFix(std::string_view text, const QuickFix& fix) {
    return spliced(text, 0, text.size(), fix.edits);
}

std::vector<Splice> difference(std::string_view before, std::string_view after) {
    if (before == after)
        return {};
    auto front = static_cast<std::size_t>(std::ranges::mismatch(before, after).in1 - before.begin());
    while (front > 0 && (isInsideCharacter(before, front) || isInsideCharacter(after, front)))
        --front;
    const auto tails = std::mismatch(before.rbegin(), before.rend() - static_cast<std::ptrdiff_t>(front),
                                     after.rbegin(), after.rend() - static_cast<std::ptrdiff_t>(front));
    auto back = static_cast<std::size_t>(tails.first - before.rbegin());
    while (back > 0 &&
           (isInsideCharacter(before, before.size() - back) || isInsideCharacter(after, after.size() - back)))
        --back;
    return {{front, before.size() - back, std::string(after.substr(front, after.size() - back - front))}};
}

std::vector<QuickFix> quickFixes(std::string_view text, const Finding& finding, const Vocabulary& vocabulary,
                                 const PlanCheck& check) {
    const auto findingsOf = [&check](std::string_view any) { return check ? check(any) : readPlan(any).findings; };
    const Count before = count(findingsOf(text), finding);
    std::vector<QuickFix> good;
    std::vector<std::string> outcomes;
    for (QuickFix& fix : FixFinder(text, finding, vocabulary).run()) {
        std::string outcome = withFix(text, fix);
        const bool is_known = std::find(outcomes.begin(), outcomes.end(), outcome) != outcomes.end();
        if (is_known || !helps(before, count(findingsOf(outcome), finding), finding))
            continue;
        good.push_back(std::move(fix));
        outcomes.push_back(std::move(outcome));
        if (good.size() == most_fixes)
            break;
    }
    return good;
}

} // namespace usar::posh
