// Numbers and durations as text for people: one spelling everywhere, and no width that jumps.
#pragma once

#include <QString>

#include "core/base/clock.h"

namespace usar::widgets {

/// Fixed decimals, decimal point, true minus sign, no minus before a zero; "–" for what is not finite. At least
/// `width` characters, filled on the left with figure spaces.
QString figure(double value, int decimals, int width = 0);
/// "00:12:31"; negative or not finite durations give "–".
QString clockText(Seconds duration);
/// "12 min 31 s", "45 s", "1 h 02 min": for sentences.
QString durationText(Seconds duration);
/// "0.3 s", "12 s", "3 min", "2 h": how old something is; five characters at most.
QString ageText(Seconds age);

} // namespace usar::widgets
