// Numbers and durations as text for the user, spelled the same everywhere and with stable widths.
#pragma once

#include <QString>

#include "core/base/clock.h"

namespace usar::widgets {

/// Formats with fixed decimals, a decimal point, a true minus sign and no minus before zero; "–" if `value` is not
/// finite. Pads on the left with figure spaces to at least `width` characters.
QString figure(double value, int decimals, int width = 0);
/// "00:12:31"; "–" for negative or non-finite durations.
QString clockText(Seconds duration);
/// "12 min 31 s", "45 s", "1 h 02 min": for sentences; "–" for negative or non-finite durations.
QString durationText(Seconds duration);
/// "0.3 s", "12 s", "3 min", "2 h": an age in at most six characters; "–" if it is not finite.
QString ageText(Seconds age);

} // namespace usar::widgets
