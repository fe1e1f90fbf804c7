#include "core/agent/parameters.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/spelling.h"

namespace usar::agent {

namespace {

std::string nearestId(const std::vector<ParameterSpec>& specs, const std::string& id) {
    std::vector<std::string> ids;
    for (const ParameterSpec& spec : specs)
        ids.push_back(spec.id);
    return nearestWord(id, ids);
}

std::string typeName(const ParameterValue& value) {
    static const char* const names[] = {"a yes or no", "a whole number", "a number", "a text"};
    return names[value.index()];
}

std::string shown(const ParameterValue& value) {
    struct Shower {
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(long long number) const { return std::to_string(number); }
        std::string operator()(double number) const { return shortest(number); }
        std::string operator()(const std::string& text) const { return '"' + text + '"'; }
    };
    return std::visit(Shower{}, value);
}

std::string shownRange(const ParameterSpec& spec) {
    return shown(spec.minimum) + " to " + shown(spec.maximum) + (spec.unit.empty() ? "" : " " + spec.unit);
}

Result<void> checkNumber(const ParameterSpec& spec, double number) {
    if (number >= spec.minimum && number <= spec.maximum) // false for NaN as well
        return {};
    return failure(shown(number) + " is out of range", "parameter " + spec.id, "Give " + shownRange(spec));
}

Result<void> checkText(const ParameterSpec& spec, const std::string& text) {
    if (spec.choices.empty() || std::ranges::find(spec.choices, text) != spec.choices.end())
        return {};
    std::string all;
    for (const std::string& choice : spec.choices)
        all += (all.empty() ? "" : ", ") + choice;
    return failure(shown(text) + " is not one of the choices", "parameter " + spec.id, "Choose one of: " + all);
}

/// The value converted to the type of its spec (whole numbers are accepted for reals), or an error.
Result<ParameterValue> checked(const ParameterSpec& spec, ParameterValue value) {
    if (std::holds_alternative<double>(spec.default_value) && std::holds_alternative<long long>(value))
        value = static_cast<double>(std::get<long long>(value));
    if (value.index() != spec.default_value.index())
        return failure(shown(value) + " is " + typeName(value), "parameter " + spec.id,
                       "Give " + typeName(spec.default_value));
    Result<void> judged;
    if (const double* number = std::get_if<double>(&value))
        judged = checkNumber(spec, *number);
    else if (const long long* whole = std::get_if<long long>(&value))
        judged = checkNumber(spec, static_cast<double>(*whole));
    else if (const std::string* text = std::get_if<std::string>(&value))
        judged = checkText(spec, *text);
    if (!judged)
        return tl::make_unexpected(judged.error());
    return value;
}

} // namespace

Result<ParameterSet> ParameterSet::make(const std::vector<ParameterSpec>& specs,
                                        const std::map<std::string, ParameterValue>& values) {
    ParameterSet set;
    for (const ParameterSpec& spec : specs)
        set.values_.emplace(spec.id, spec.default_value);
    for (const auto& [id, value] : values) {
        const auto spec = std::ranges::find(specs, id, &ParameterSpec::id);
        if (spec == specs.end())
            return failure("there is no such parameter", "parameter " + id,
                           specs.empty() ? "This behavior has none" : "Did you mean " + nearestId(specs, id) + "?");
        Result<ParameterValue> judged = checked(*spec, value);
        if (!judged)
            return tl::make_unexpected(judged.error());
        set.values_[id] = *std::move(judged);
    }
    return set;
}

} // namespace usar::agent
