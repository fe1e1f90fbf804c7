// Typed parameters of a behavior: what a form shows, a mission file sets and a behavior reads.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace usar::agent {

using ParameterValue = std::variant<bool, long long, double, std::string>;

/// One parameter as its author describes it. The alternative held by `default_value` is the type. Numbers are SI and
/// radians; widgets and files that people write show angles in degrees where `unit` is "rad".
struct ParameterSpec {
    std::string id;    ///< "scan_altitude_m": the unit is part of the name
    std::string label; ///< "Scan altitude"
    std::string group; ///< "Flight"
    std::string unit;  ///< "m", "m/s", "rad", "%", "s", "" for none
    ParameterValue default_value;
    double minimum = 0.0; ///< numbers only, inclusive
    double maximum = 0.0;
    std::string help;                 ///< one sentence
    std::vector<std::string> choices; ///< for a text that is one of several

    bool operator==(const ParameterSpec&) const = default;
};

/// A complete, valid set of values for a list of specs.
class ParameterSet {
public:
    /// Defaults, overridden by `values`. An unknown id (the error names the nearest), a wrong type or a value out of
    /// range is an error that names parameter, value and range. Whole numbers are taken for reals.
    static Result<ParameterSet> make(const std::vector<ParameterSpec>& specs,
                                     const std::map<std::string, ParameterValue>& values = {});

    /// Asking for an id that has no spec, or for the wrong type, is a bug (assertion).
    double real(const std::string& id) const;
    long long integer(const std::string& id) const;
    bool flag(const std::string& id) const;
    const std::string& text(const std::string& id) const;
    const std::map<std::string, ParameterValue>& values() const { return values_; }
    bool operator==(const ParameterSet&) const = default;

private:
    std::map<std::string, ParameterValue> values_;
};

} // namespace usar::agent
