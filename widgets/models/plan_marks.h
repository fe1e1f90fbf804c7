// What a person put on the parts of a plan, and where it stands still: breakpoints, pins, drives that are off.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// On one part.
struct PlanMark {
    std::string path;         ///< of the engine
    int breakpoints = 0;      ///< that are on
    int breakpoints_off = 0;  ///< that are not
    bool conditional = false; ///< one of them does not stop always
    bool pinned = false;      ///< it answers what a person wants
    bool switched_off = false;
    bool halted = false; ///< the plan stands still here
    QStringList words{}; ///< all of that, for people
    bool operator==(const PlanMark&) const = default;
};

/// By node of a drawn plan. What is drawn once for several places has the marks of all of them.
class PlanMarks {
public:
    PlanMarks() = default;
    PlanMarks(const PlanTree& tree, const std::vector<PlanMark>& marks);

    /// Null for a node without any.
    const PlanMark* at(int node) const;
    bool empty() const { return by_node_.empty(); }

private:
    std::map<int, PlanMark> by_node_;
};

} // namespace usar::widgets
