// Typed parameters of a behavior, which are shown in forms, set in mission files and read by the behavior.
#pragma once

#include <cassert>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace usar::agent {

/// The index of an alternative is part of the format in behavior_frames.h.
using ParameterValue = std::variant<bool, long long, double, std::string>;

/// The description of one parameter. The alternative held by `default_value` is its type. Numbers are in SI units and
/// radians; widgets and hand-written files show angles in degrees if `unit` is "rad".
struct ParameterSpec {
    std::string id;    ///< "scan_altitude_m": the unit is part of the name
    std::string label; ///< "Scan altitude"
    std::string group; ///< "Flight"
    std::string unit;  ///< "m", "m/s", "rad", "%", "s", "" for none
    ParameterValue default_value;
    double minimum = 0.0; ///< numbers only, inclusive
    double maximum = 0.0;
    std::string help;                 ///< one sentence
    std::vector<std::string> choices; ///< permitted texts; empty if any text is permitted

    bool operator==(const ParameterSpec&) const = default;
};

/// A complete, valid set of values for a list of specs. An empty set can be default-constructed.
class ParameterSet {
public:
    /// The defaults, overridden by `values`. Returns an error if an id is unknown (it suggests the nearest), or if a
    /// value has the wrong type or is out of range (it names parameter, value and range). Whole numbers are accepted
    /// for reals.
    static Result<ParameterSet> make(const std::vector<ParameterSpec>& specs,
                                     const std::map<std::string, ParameterValue>& values = {});

    /// The id must have a spec of the requested type (assertion).
    double real(const std::string& id) const { return valueOf<double>(id); }
    long long integer(const std::string& id) const { return valueOf<long long>(id); }
    bool flag(const std::string& id) const { return valueOf<bool>(id); }
    const std::string& text(const std::string& id) const { return valueOf<std::string>(id); }
    /// Copies the value to `into`, whose type must be that of the parameter (assertion).
    template <class Value>
    void read(const std::string& id, Value& into) const {
        into = valueOf<Value>(id);
    }
    /// All values by id, including defaults.
    const std::map<std::string, ParameterValue>& values() const { return values_; }
    bool operator==(const ParameterSet&) const = default;

private:
    template <class Value>
    const Value& valueOf(const std::string& id) const {
        const auto found = values_.find(id);
        assert(found != values_.end() && "a parameter that has no spec was asked for");
        const auto* const value = std::get_if<Value>(&found->second);
        assert(value && "a parameter was asked for as another type than its spec's");
        return *value;
    }

    std::map<std::string, ParameterValue> values_;
};

} // namespace usar::agent
