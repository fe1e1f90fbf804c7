// Plans for the tests of the plan view, and the shortest way to make one from its text.
#pragma once

#include <string_view>

#include <QTest>

#include "core/posh/language/plan_reader.h"

namespace usar {

inline posh::Plan planOf(std::string_view text) {
    return posh::readPlan(text).plan;
}

/// A little of everything: goals, levels of equals, arguments, limits, a form used twice.
inline constexpr std::string_view courier_plan = R"((
  (documentation "Courier" "test" "Carries parcels.")
  (C fetch (minutes 2) (goal ((Loaded)))
    (elements
      ((grab (trigger ((Distance 0.3 <) (Loaded false))) CloseGripper 3 "only when near"))
      ((near (trigger ((Distance 2.0 <))) approach) (beep Beep))
      ((go DriveTo("depot", $speed=1.5)))))
  (AP approach vars($speed=0.5) (Slow (Distance 1.0 <) halt))
  (AP halt (Stop Brake))
  (AD wait ((goal ((Rested))) (Rest)))
  (DC courier (goal ((Delivered)))
    (drives
      ((safety (trigger ((Bumped))) halt (seconds 2)))
      ((work (trigger ((Battery 0.2 >) (Bumped false))) fetch))
      ((rest wait)))))
)";

} // namespace usar
