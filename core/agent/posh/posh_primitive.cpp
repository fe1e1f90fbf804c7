#include "core/agent/posh/posh_primitive.h"

#include "core/base/numbers.h"

namespace usar::agent {

namespace {

std::string rangeText(const PoshParameter& parameter) {
    if (parameter.minimum == 0.0 && parameter.maximum == 0.0)
        return {};
    const std::string text = " from " + shortest(parameter.minimum) + " to " + shortest(parameter.maximum);
    return parameter.unit.empty() ? text : text + " " + parameter.unit;
}

std::string choicesText(const PoshParameter& parameter) {
    std::string text;
    for (const std::string& choice : parameter.choices)
        text += (text.empty() ? "one of '" : ", '") + choice;
    return text.empty() ? "a symbol" : text;
}

} // namespace

std::string typeText(const PoshParameter& parameter) {
    if (std::holds_alternative<bool>(parameter.default_value))
        return "true or false";
    if (std::holds_alternative<std::int64_t>(parameter.default_value))
        return "a whole number" + rangeText(parameter);
    if (std::holds_alternative<double>(parameter.default_value))
        return "a number" + rangeText(parameter);
    return std::holds_alternative<std::string>(parameter.default_value) ? "a text" : choicesText(parameter);
}

} // namespace usar::agent
