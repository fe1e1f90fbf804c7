// The user's breakpoints of all plans, as text for the user and as JSON.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/agent/plan_control.h"
#include "widgets/models/plan/plan_spots.h"

namespace usar::widgets {

/// A breakpoint in the panel's list.
struct BreakpointRow {
    agent::BreakpointId id;
    QString text;
    QString help;
    std::string path; ///< path in the plan; empty: the plan has no such place
    bool enabled = true;
};

/// Breakpoints in the order in which they were set. Each has an id that stays unique while the program runs.
class BreakpointList {
public:
    /// All breakpoints with their ids; the reference is valid until the list changes.
    const std::vector<agent::PlanBreakpoint>& all() const { return all_; }
    /// Returns nullptr if no breakpoint has this id. The pointer is valid until the list changes.
    const posh::Breakpoint* find(agent::BreakpointId id) const;
    /// Returns the id of the new breakpoint.
    agent::BreakpointId add(posh::Breakpoint breakpoint);
    /// Changing or removing an unknown id has no effect.
    void change(agent::BreakpointId id, posh::Breakpoint breakpoint);
    void remove(agent::BreakpointId id) {
        std::erase_if(all_, [id](const auto& one) { return one.id == id; });
    }
    void remove(const std::vector<agent::BreakpointId>& ids);
    /// Removes the breakpoints of this kind at these places of a plan; sets one at each place if there are none.
    void toggle(std::string_view plan_name, const std::vector<PlanSpot>& spots, posh::BreakOn on);
    /// The same for a key of the program's blackboard.
    void toggleKey(const posh::Program& program, const std::string& key);
    /// Enables or disables a breakpoint; an unknown id has no effect.
    void enable(agent::BreakpointId id, bool on);
    /// Disables these breakpoints if one of them is enabled, else enables them.
    void toggleEnabled(const std::vector<agent::BreakpointId>& ids);
    /// Ids of the breakpoints of a plan, by the plan's name.
    std::vector<agent::BreakpointId> ofPlan(std::string_view name) const;
    /// The same for the list of the plan's panel.
    std::vector<BreakpointRow> rowsOfPlan(std::string_view name) const;
    /// The keys of the blackboard that this plan's breakpoints watch.
    QStringList keysOfPlan(std::string_view name) const;
    /// Ids of the breakpoints on a key of the plan's blackboard; those have no path.
    std::vector<agent::BreakpointId> ofKey(std::string_view plan_name, std::string_view key) const;
    /// Ids of the breakpoints at one path of a plan.
    std::vector<agent::BreakpointId> atPath(std::string_view plan_name, std::string_view path) const;
    /// Ids of the breakpoints at these places of a plan, of all kinds or of one.
    std::vector<agent::BreakpointId> atSpots(std::string_view plan_name, const std::vector<PlanSpot>& spots,
                                             std::optional<posh::BreakOn> on = std::nullopt) const;
    /// Finds the places of this program's breakpoints again by their names and updates their paths; the path becomes
    /// empty if the program has no such place.
    void repairPaths(const posh::Program& program);

    /// Sets a breakpoint before each of these places that lasts until a plan halts; earlier ones of this kind go.
    void setTemporary(const std::vector<PlanSpot>& spots);
    /// Returns true if there were any.
    bool dropTemporary();
    /// Disables a breakpoint that stops only once, because it has stopped a plan; an unknown id has no effect.
    void takeHit(agent::BreakpointId id);

    /// Without temporary breakpoints. Writes the list as JSON, and reads it back with new ids; entries that are not
    /// valid breakpoints are left out.
    QByteArray toJson() const;
    static BreakpointList fromJson(const QByteArray& json);

private:
    std::vector<agent::PlanBreakpoint> all_;
    std::vector<agent::BreakpointId> temporary_;
    int next_id_ = 1; ///< number of the next id
};

/// When the breakpoint stops: "before", "when it answers: failed".
QString breakOnText(const posh::Breakpoint& breakpoint);
/// "work, before, if (distance 0.3 <), from hit 4 on, once": for lists and tooltips.
QString breakpointText(const posh::Breakpoint& breakpoint);
/// "finished", "still running": an act's answer as the user reads it.
QString resultText(posh::ActResult result);

} // namespace usar::widgets
