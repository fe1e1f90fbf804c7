#include "core/posh/edit/plan_templates.h"

namespace usar::posh {

const std::vector<PlanTemplate>& planTemplates() {
    static const std::vector<PlanTemplate> templates{
        {"Empty plan", "One drive that does nothing, to build on.", R"((
  (documentation "New plan" "" "What the plan is for.")

  (DC life
    (drives
      ((idle doNothing)))))
)"},
        {"Watch and work", "A drive for danger before one for work that has steps to choose from.", R"((
  (documentation "Watch and work" "" "Reacts to danger first, else works.")

  ; The first element whose trigger holds is done; the last one has none, so that there is always something to do.
  (C work
    (elements
      ((prepare (trigger ((fail))) doNothing))
      ((go-on   doNothing))))

  ; Drives stand in the order of their importance and are asked again in every cycle.
  (DC life
    (drives
      ((danger (trigger ((fail))) doNothing))
      ((work   work)))))
)"},
        {"Mission with an end", "Steps in a row, done once; the plan ends when its goal holds.", R"((
  (documentation "Mission" "" "Does its steps one after the other and ends.")

  (AP set-out (doNothing doNothing))
  (C mission (goal ((fail)))
    (elements
      ((start (trigger ((succeed))) set-out 1))
      ((stay  doNothing))))

  ; The goal ends the plan: put the sense here that says the mission is over.
  (DC robot (goal ((fail)))
    (drives
      ((mission mission)))))
)"}};
    return templates;
}

} // namespace usar::posh
