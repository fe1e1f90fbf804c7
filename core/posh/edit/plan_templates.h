// Templates for new plans: each binds to any robot and runs immediately.
#pragma once

#include <string>
#include <vector>

namespace usar::posh {

struct PlanTemplate {
    std::string title; ///< "Watch and work"
    std::string help;  ///< one sentence that describes the template
    std::string text;  ///< the plan itself
};

/// Returns all templates. They use only the senses and acts of the engine itself (`succeed`, `fail`, `doNothing`); the
/// first template is the smallest.
const std::vector<PlanTemplate>& planTemplates();

} // namespace usar::posh
