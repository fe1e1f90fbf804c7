// A sense or an act as its robot describes it: what a palette shows, completion offers and a plan is checked against.
#pragma once

#include <string>
#include <vector>

#include "core/posh/plan.h"

namespace usar::agent {

/// One parameter. The alternative held by `default_value` is the type; numbers are SI and radians.
struct PoshParameter {
    std::string name; ///< as in plans, without the dollar
    posh::Value default_value;
    std::string unit;                 ///< "m", "s", "" for none
    double minimum = 0.0;             ///< numbers only, inclusive; both 0: no range
    double maximum = 0.0;             //
    std::vector<std::string> choices; ///< for a symbol that is one of several
    std::string help;                 ///< one sentence
    bool operator==(const PoshParameter&) const = default;

    static PoshParameter number(std::string name, double value, std::string unit, double minimum, double maximum,
                                std::string help = {});
    static PoshParameter whole(std::string name, std::int64_t value, std::int64_t minimum, std::int64_t maximum,
                               std::string help = {});
    static PoshParameter flag(std::string name, bool value, std::string help = {});
    static PoshParameter text(std::string name, std::string value, std::string help = {});
    static PoshParameter symbol(std::string name, std::string value, std::vector<std::string> choices,
                                std::string help = {});
};

enum class PrimitiveKind { Sense, Act };
enum class AnswerType { Any, Boolean, Integer, Real, Text, Symbol };

struct PrimitiveDescription {
    std::string name;
    PrimitiveKind kind = PrimitiveKind::Sense;
    std::vector<PoshParameter> parameters;
    AnswerType answer = AnswerType::Any; ///< of a sense
    std::string unit;                    ///< of the answer
    std::string help;                    ///< one sentence
    std::vector<std::string> needs;      ///< sensors and commands, by their names on the wire
    double minimum = 0.0;                ///< of a number that a sense answers with; both 0: no range
    double maximum = 0.0;                //
    std::vector<std::string> choices{};  ///< of a symbol that a sense answers with
    bool operator==(const PrimitiveDescription&) const = default;
};

/// "a whole number", "one of 'none, 'low, 'high".
std::string typeText(const PoshParameter& parameter);

} // namespace usar::agent
