// Descriptions of a robot's senses and acts, for the palette, for completion and for checking plans.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/posh/model/plan.h"

namespace usar::agent {

/// One parameter. The alternative held by `default_value` is its type; numbers are in SI units and radians.
struct PoshParameter {
    std::string name; ///< as in plans, without the dollar
    posh::Value default_value;
    std::string unit;                 ///< "m", "s", "" for none
    double minimum = 0.0;             ///< numbers only, inclusive; no range if both are 0
    double maximum = 0.0;             //
    std::vector<std::string> choices; ///< permitted symbols; empty if any symbol is permitted
    std::string help;                 ///< one sentence
    bool operator==(const PoshParameter&) const = default;

    /// Parameters of each type; `value` is the default.
    static PoshParameter number(std::string name, double value, std::string unit, double minimum, double maximum,
                                std::string help = {}) {
        return {std::move(name), value, std::move(unit), minimum, maximum, {}, std::move(help)};
    }
    /// A whole number has no unit.
    static PoshParameter whole(std::string name, std::int64_t value, std::int64_t minimum, std::int64_t maximum,
                               std::string help = {}) {
        return {std::move(name), value, {}, static_cast<double>(minimum), static_cast<double>(maximum), {},
                std::move(help)};
    }
    static PoshParameter flag(std::string name, bool value, std::string help = {}) {
        return {std::move(name), value, {}, 0.0, 0.0, {}, std::move(help)};
    }
    static PoshParameter text(std::string name, std::string value, std::string help = {}) {
        return {std::move(name), std::move(value), {}, 0.0, 0.0, {}, std::move(help)};
    }
    /// `value` is spelled without the quote of the language, as are `choices`.
    static PoshParameter symbol(std::string name, std::string value, std::vector<std::string> choices,
                                std::string help = {}) {
        return {std::move(name), posh::Symbol{std::move(value)}, {}, 0.0, 0.0, std::move(choices), std::move(help)};
    }
};

/// A sense answers a question without changing anything; an act makes the robot do something.
enum class PrimitiveKind { Sense, Act };
/// The type of a sense's answer; Any if it may change from call to call.
enum class AnswerType { Any, Boolean, Integer, Real, Text, Symbol };

/// One sense or act.
struct PrimitiveDescription {
    std::string name;
    PrimitiveKind kind = PrimitiveKind::Sense;
    /// In the order in which positional arguments are matched to them.
    std::vector<PoshParameter> parameters;
    AnswerType answer = AnswerType::Any; ///< for a sense
    std::string unit;                    ///< unit of the answer
    std::string help;                    ///< one sentence
    std::vector<std::string> needs;      ///< sensors and commands, by their names on the wire
    double minimum = 0.0;                ///< range of a sense's number, inclusive; no range if both are 0
    double maximum = 0.0;                //
    std::vector<std::string> choices{};  ///< symbols that a sense may answer
    bool operator==(const PrimitiveDescription&) const = default;
};

/// The type, range and choices in words: "a whole number from 1 to 9", "one of 'none, 'low, 'high".
std::string typeText(const PoshParameter& parameter);

} // namespace usar::agent
