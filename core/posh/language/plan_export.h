// Export of plans to other dialects of POSH, with a list of what those cannot express.
#pragma once

#include <string>
#include <vector>

#include "core/posh/model/plan.h"

namespace usar::posh {

enum class Dialect {
    Classic, ///< the strict .lap of jyposh and POSH#
    Yaposh,  ///< Pogamut 3
};

/// A feature that the dialect does not have.
struct Loss {
    Spot at;             ///< place in the original plan; line 0 if the plan was not read from a text
    std::string message; ///< what the dialect lacks and what replaces it
};

struct PlanExport {
    std::string text;         ///< in the canonical layout
    std::vector<Loss> losses; ///< in the order of the text
};

/// Converts a plan. A part that is only spelled differently in the dialect is converted without a message. A feature
/// that the dialect lacks is replaced by the nearest one, or left out, and reported as a loss. Exporting the result
/// again loses nothing more. For Classic, DC and RDC become SDC and SRDC, because its engines run only those and treat
/// them alike.
PlanExport exportPlan(const Plan& plan, Dialect dialect);

} // namespace usar::posh
