// The breakpoints of all plans as a person has set them, and how they are told and kept.
#pragma once

#include <string_view>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/agent/plan_control.h"

namespace usar::widgets {

/// In the order in which they were set. Each has a number of its own while the program runs.
class BreakpointList {
public:
    const std::vector<agent::PlanBreakpoint>& all() const { return all_; }
    /// Null where there is none of that number.
    const posh::Breakpoint* find(int id) const;
    /// Its number.
    int add(posh::Breakpoint breakpoint);
    void change(int id, posh::Breakpoint breakpoint);
    void remove(int id);
    /// The numbers of those of a plan, by its name, or of those at one place of it.
    std::vector<int> ofPlan(std::string_view name) const;
    /// Of a key of the plan's blackboard; those are at no place.
    std::vector<int> ofKey(std::string_view plan_name, std::string_view key) const;
    std::vector<int> atPath(std::string_view plan_name, std::string_view path) const;
    /// Places of this program are found again by their names.
    void repairPaths(const posh::Program& program);

    /// As JSON, and back; what is no breakpoint is left out.
    QByteArray toJson() const;
    static BreakpointList fromJson(const QByteArray& json);

private:
    std::vector<agent::PlanBreakpoint> all_;
    int next_id_ = 1;
};

/// "before", "when it answers failed": when it stops.
QString breakOnText(const posh::Breakpoint& breakpoint);
/// "work, before, if (distance 0.3 <), from hit 4 on, once": for lists and tooltips.
QString breakpointText(const posh::Breakpoint& breakpoint);
/// "finished", "runs on": an act's answer for people.
QString resultText(posh::ActResult result);

} // namespace usar::widgets
