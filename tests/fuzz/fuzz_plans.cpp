// Any bytes through everything that reads and writes plans. What is asserted: places lie inside of the text, a sound
// plan reads back equal from both layouts, also after an edit, writing is stable, and exports are read.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/posh/language/plan_export.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/model/plan_walk.h"

namespace {

using namespace usar::posh;

void check(bool holds) {
    if (!holds)
        std::abort();
}

void checkPlaces(const Findings& findings, std::string_view text) {
    for (const Finding& finding : findings) {
        check(finding.at.line > 0 && finding.at.column > 0);
        check(finding.at.offset <= text.size() && finding.at.length <= text.size() - finding.at.offset);
        check(!finding.message.empty());
    }
}

/// A form is moved and a call renamed, as an editor does it.
void checkEditing(std::string_view text, Plan plan) {
    if (plan.forms.empty())
        return;
    std::rotate(plan.forms.begin(), plan.forms.begin() + 1, plan.forms.end());
    forEachCall(plan.forms.front(), [](Call& call, bool) { call.name.text = "renamed"; });
    const PlanReading again = readPlan(writeKeepingLayout(text, plan));
    check(again.plan.forms.size() == plan.forms.size());
    for (const Finding& finding : again.findings)
        check(static_cast<int>(finding.code) > 300); // what a form is called now may be its own name
}

void checkWriting(std::string_view text, const Plan& plan) {
    const std::string written = writePlan(plan);
    const PlanReading again = readPlan(written);
    check(!hasErrors(again.findings) && again.plan == plan);
    check(writePlan(again.plan) == written);
    check(writeKeepingLayout(text, plan) == text);
    checkEditing(text, plan);
    for (const Dialect dialect : {Dialect::Classic, Dialect::Yaposh})
        for (const Finding& finding : readPlan(exportPlan(plan, dialect).text).findings)
            check(static_cast<int>(finding.code) > 300); // two names may have become one
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const PlanReading reading = readPlan(text);
    checkPlaces(reading.findings, text);
    if (!hasErrors(reading.findings))
        checkWriting(text, reading.plan);
    else
        writePlan(reading.plan);
    return 0;
}
