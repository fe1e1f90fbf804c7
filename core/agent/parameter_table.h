// A table that links each parameter of a behavior to its member in the behavior's settings and to its entry in a form.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "core/agent/parameters.h"

namespace usar::agent {

/// One row, such as {&Settings::turn_rad, "turn_rad", "Turn", "Getting out", "rad", radians(10), radians(180), "How far
/// the robot turns."}. `Settings` is a plain aggregate that a behavior copies, so that new parameters take effect at
/// its next tick. Units and texts are as in ParameterSpec. The default is the value in a default-constructed
/// `Settings`.
template <class Settings>
struct ParameterRow {
    std::variant<double Settings::*, long long Settings::*, bool Settings::*> member;
    const char* id;
    const char* label;
    const char* group;
    const char* unit;
    double minimum; ///< for numbers, inclusive
    double maximum;
    const char* help;
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
