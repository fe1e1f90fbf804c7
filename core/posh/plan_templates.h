// Plans to begin with: each binds to any robot and runs at once.
#pragma once

#include <string>
#include <vector>

namespace usar::posh {

struct PlanTemplate {
    std::string title; ///< "Watch and work"
    std::string help;  ///< one sentence
    std::string text;
};

/// They use nothing but what the engine has itself (`succeed`, `fail`, `doNothing`); the first is the smallest.
const std::vector<PlanTemplate>& planTemplates();

} // namespace usar::posh
