// Typed parameters of a behavior, which are shown in forms, set in mission files and read by the behavior.
#pragma once

#include <cassert>
#include <map>
#include <span>
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
    /// Forms show this text in place of the lowest number, if that stands for something else: "by the robot".
    std::string minimum_words = {};

    bool operator==(const ParameterSpec&) const = default;
};

/// A proven way to use a behavior: values under a name. What it does not name has its default.
struct ParameterPreset {
    std::string id;   ///< "as-in-the-thesis": files and command lines name it so
    std::string name; ///< "As in the thesis"
    std::string help; ///< one sentence
    std::map<std::string, ParameterValue> values;

    bool operator==(const ParameterPreset&) const = default;
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
    /// Whole numbers are stored as long long, never as a real.
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

/// One row, such as {&Settings::turn_rad, "turn_rad", "Turn", "Getting out", "rad", radians(10), radians(180), "How far
/// the robot turns."}. `Settings` is a plain aggregate that a behavior copies, so that new parameters take effect at
/// its next tick. Units and texts are as in ParameterSpec. The default is the value in a default-constructed
/// `Settings`.
template <class Settings>
struct ParameterRow {
    std::variant<double Settings::*, long long Settings::*, bool Settings::*> member;
    /// All texts are static.
    const char* id;
    const char* label;
    const char* group;
    const char* unit;
    double minimum; ///< for numbers, inclusive
    double maximum;
    const char* help;
    const char* minimum_words = "";
};

/// The parameters that the user can set. `rows` must outlive the table: a constexpr array in the settings' source file.
template <class Settings>
struct ParameterTable {
    std::span<const ParameterRow<Settings>> rows;

    /// The specs for a form, in the order of the rows.
    std::vector<ParameterSpec> specs() const {
        static const Settings defaults{}; // static, because GCC 12 warns that one on the stack is uninitialized
        std::vector<ParameterSpec> specs;
        for (const ParameterRow<Settings>& row : rows) {
            specs.push_back({row.id, row.label, row.group, row.unit, 0.0, row.minimum, row.maximum, row.help, {}});
            specs.back().minimum_words = row.minimum_words;
            std::visit([&](auto member) { specs.back().default_value = defaults.*member; }, row.member);
        }
        return specs;
    }

    /// The settings with the values of `parameters`, which must have been made from `specs()`.
    Settings settings(const ParameterSet& parameters) const {
        Settings settings{};
        for (const ParameterRow<Settings>& row : rows)
            std::visit([&](auto member) { parameters.read(row.id, settings.*member); }, row.member);
        return settings;
    }
};

} // namespace usar::agent
