// How parameters are shown to the user: unit, factor, decimals and tooltip.
#pragma once

#include <QString>

#include "core/agent/parameters.h"

namespace usar::widgets {

/// Shown number = SI number * factor. Angles ("rad", "rad/s", "rad/s2") are shown in degrees; other units are
/// unchanged.
struct DisplayUnit {
    QString text; ///< "m/s", "°"; empty: none
    double factor = 1.0;
    bool operator==(const DisplayUnit&) const = default;
};
/// Unit in which values with this SI unit are shown.
DisplayUnit displayUnit(const std::string& unit);

/// Decimals that an editor needs: fine enough for the range, and enough to show the default as its author wrote it; 0
/// for types other than real numbers.
int decimalsFor(const agent::ParameterSpec& spec);
/// Step of the editor's arrows, in shown units: about a fiftieth of the range, rounded to 1, 2 or 5 times a power of
/// ten.
double stepFor(const agent::ParameterSpec& spec);

/// "6.5 m", "30 °", "yes": in shown units, without trailing zeros.
QString valueText(const agent::ParameterSpec& spec, const agent::ParameterValue& value);
/// HTML with label, help, unit, range, default and id, each on a line of its own.
QString parameterToolTip(const agent::ParameterSpec& spec);

/// Returns `value` converted to the type of the spec (a whole number is accepted as a real), or the default if the type
/// does not fit or the number is out of range.
agent::ParameterValue fitted(const agent::ParameterSpec& spec, const agent::ParameterValue& value);
/// True if the values are equal; real numbers may differ by the rounding error of a conversion to degrees and back.
bool sameValue(const agent::ParameterValue& a, const agent::ParameterValue& b);

} // namespace usar::widgets
