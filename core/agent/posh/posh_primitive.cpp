#include "core/agent/posh/posh_primitive.h"

#include <utility>

#include "core/base/numbers.h"

namespace usar::agent {

PoshParameter PoshParameter::number(std::string name, double value, std::string unit, double minimum, double maximum,
                                    std::string help) {
    return {std::move(name), value, std::move(unit), minimum, maximum, {}, std::move(help)};
}

PoshParameter PoshParameter::whole(std::string name, std::int64_t value, std::int64_t minimum, std::int64_t maximum,
                                   std::string help) {
    return {std::move(name), value, {}, static_cast<double>(minimum), static_cast<double>(maximum), {},
            std::move(help)};
}

PoshParameter PoshParameter::flag(std::string name, bool value, std::string help) {
    return {std::move(name), value, {}, 0.0, 0.0, {}, std::move(help)};
}

PoshParameter PoshParameter::text(std::string name, std::string value, std::string help) {
    return {std::move(name), std::move(value), {}, 0.0, 0.0, {}, std::move(help)};
}

PoshParameter PoshParameter::symbol(std::string name, std::string value, std::vector<std::string> choices,
                                    std::string help) {
    return {std::move(name), posh::Symbol{std::move(value)}, {}, 0.0, 0.0, std::move(choices), std::move(help)};
}

namespace {

std::string rangeText(const PoshParameter& parameter) {
    if (parameter.minimum == 0.0 && parameter.maximum == 0.0)
        return {};
    std::string text = " from ";
    appendShortest(text, parameter.minimum);
    text += " to ";
    appendShortest(text, parameter.maximum);
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
