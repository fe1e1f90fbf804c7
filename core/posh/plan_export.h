// Plans for the other readers of POSH, and what those cannot express.
#pragma once

#include <string>
#include <vector>

#include "core/posh/plan.h"

namespace usar::posh {

enum class Dialect {
    Classic, ///< the strict .lap of jyposh and POSH#
    Yaposh,  ///< Pogamut 3
};

/// What the dialect lacks, where the plan has it, and what stands there now.
struct Loss {
    Spot at;
    std::string message;
    bool operator==(const Loss&) const = default;
};

struct PlanExport {
    std::string text; ///< in the canonical layout
    std::vector<Loss> losses;
};

/// What has another spelling in the dialect gets it without a word; what it lacks is replaced by the nearest it has, or
/// left out, and told. An export exported again loses nothing more. DC and RDC become SDC and SRDC for Classic, whose
/// engines run no others and treat them alike.
PlanExport exportPlan(const Plan& plan, Dialect dialect);

} // namespace usar::posh
