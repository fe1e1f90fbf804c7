// Reads and checks the text of a plan that is being edited, alone or against the senses and acts of a robot.
#pragma once

#include <string_view>
#include <vector>

#include "core/agent/posh/posh_primitive.h"
#include "core/posh/edit/quick_fixes.h"
#include "core/posh/language/plan_reader.h"

namespace usar::widgets {

/// Keeps the result for the newest text, so that a text is checked only once.
class PlanChecker {
public:
    /// The senses and acts of the robot that the plan is for; empty: plans are checked without a robot.
    void setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives);
    /// True if plans are checked against a robot.
    bool binds() const { return !primitives_.empty(); }

    /// Makes the next call of check read the text, because it has changed.
    void invalidate() { is_current_ = false; }
    bool isCurrent() const { return is_current_; }
    /// Reads and checks the text unless that has been done since the last change.
    void check(std::string_view text);
    /// Results of the last check.
    const posh::Findings& findings() const { return findings_; }
    const posh::Plan& plan() const { return plan_; }
    /// True if the plan has no errors and a drive collection, so that a robot can run it.
    bool isRunnable() const { return !posh::hasErrors(findings_) && posh::collectionOf(plan_); }

    /// The fixes known for a finding of this text, which must be the one that was checked last.
    std::vector<posh::QuickFix> fixes(std::string_view text, const posh::Finding& finding) const;

private:
    /// Reads and checks any text without keeping the result.
    posh::PlanReading read(std::string_view text) const;

    std::vector<agent::PrimitiveDescription> primitives_;
    posh::Vocabulary vocabulary_;
    posh::Findings findings_;
    posh::Plan plan_;
    bool is_current_ = false;
};

} // namespace usar::widgets
