// One table says where in a behavior's settings a parameter's value lies and what a form shows of it.
#pragma once

#include <variant>
#include <vector>

#include "core/agent/parameters.h"

namespace usar::agent {

/// A row of the table of `Settings`, a plain aggregate that a behavior copies: new parameters take effect at its next
/// tick. Units as in ParameterSpec. The default is what a default-made `Settings` has there.
template <class Settings>
struct ParameterRow {
    std::variant<double Settings::*, long long Settings::*, bool Settings::*> member;
    const char* id;
    const char* label;
    const char* group;
    const char* unit;
    double minimum; ///< of numbers, inclusive
    double maximum;
    const char* help;
};

/// What a form shows, in the table's order.
template <class Settings>
std::vector<ParameterSpec> specsOf(const std::vector<ParameterRow<Settings>>& table) {
    static const Settings defaults{}; // static: GCC 12 takes one on the stack for uninitialized
    std::vector<ParameterSpec> specs;
    for (const ParameterRow<Settings>& row : table) {
        specs.push_back({row.id, row.label, row.group, row.unit, 0.0, row.minimum, row.maximum, row.help, {}});
        std::visit([&](auto member) { specs.back().default_value = defaults.*member; }, row.member);
    }
    return specs;
}

/// `parameters` were made from `specsOf(table)`.
template <class Settings>
Settings settingsOf(const std::vector<ParameterRow<Settings>>& table, const ParameterSet& parameters) {
    struct Load {
        Settings& into;
        const ParameterSet& from;
        const char* id;
        void operator()(double Settings::*member) const { into.*member = from.real(id); }
        void operator()(long long Settings::*member) const { into.*member = from.integer(id); }
        void operator()(bool Settings::*member) const { into.*member = from.flag(id); }
    };
    Settings settings{};
    for (const ParameterRow<Settings>& row : table)
        std::visit(Load{settings, parameters, row.id}, row.member);
    return settings;
}

} // namespace usar::agent
