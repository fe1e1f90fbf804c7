// How a parameter looks to people: its unit, factor and decimals, and the text of its tooltip.
#pragma once

#include <QString>

#include "core/agent/parameters.h"

namespace usar::widgets {

/// Shown number = SI number * factor. Angles ("rad", "rad/s", "rad/s2") are shown in degrees, all else as it is.
struct DisplayUnit {
    QString text; ///< "m/s", "°", "" for none
    double factor = 1.0;
    bool operator==(const DisplayUnit&) const = default;
};
DisplayUnit displayUnit(const std::string& unit);

/// Decimals that an editor needs: fine enough for the range, and enough to show the default as its author wrote it.
int decimalsFor(const agent::ParameterSpec& spec);
/// What one click on an arrow adds, in shown units: about a fiftieth of the range, of the form 1, 2 or 5 times a power
/// of ten.
double stepFor(const agent::ParameterSpec& spec);

/// "6.5 m", "30 °", "yes": in shown units, no superfluous zeros.
QString valueText(const agent::ParameterSpec& spec, const agent::ParameterValue& value);
/// What, id, unit, range and default, each on its line.
QString parameterToolTip(const agent::ParameterSpec& spec);

/// `value` in the type of the spec (a whole number is taken for a real), or the default where the type does not fit
/// or the number is out of range.
agent::ParameterValue fitted(const agent::ParameterSpec& spec, const agent::ParameterValue& value);
/// The same number up to what survives a trip through degrees.
bool sameValue(const agent::ParameterValue& a, const agent::ParameterValue& b);

} // namespace usar::widgets
