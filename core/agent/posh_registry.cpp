#include "core/agent/posh_registry.h"

#include <algorithm>
#include <cassert>

#include "core/posh/run/value_text.h"

namespace usar::agent {

using posh::Symbol;
using posh::Value;

namespace {

bool inRange(const PoshParameter& parameter, double number) {
    const bool has_range = parameter.minimum != 0.0 || parameter.maximum != 0.0;
    return !has_range || (number >= parameter.minimum && number <= parameter.maximum);
}

std::optional<Value> asSymbol(const PoshParameter& parameter, const Value& value) {
    const auto* const symbol = std::get_if<Symbol>(&value);
    const auto* const text = std::get_if<std::string>(&value);
    if (!symbol && !text)
        return std::nullopt;
    const std::string& constant = symbol ? symbol->text : *text;
    std::string word = constant.substr(constant.rfind('.') + 1); // the last part of an enumeration constant
    const bool fits = parameter.choices.empty() || std::ranges::count(parameter.choices, word) > 0;
    return fits ? std::optional<Value>(Symbol{std::move(word)}) : std::nullopt;
}

std::optional<Value> converted(const PoshParameter& parameter, const Value& value) {
    if (std::holds_alternative<Symbol>(parameter.default_value))
        return asSymbol(parameter, value);
    if (std::holds_alternative<double>(parameter.default_value) && std::holds_alternative<std::int64_t>(value))
        return converted(parameter, static_cast<double>(std::get<std::int64_t>(value)));
    if (value.index() != parameter.default_value.index())
        return std::nullopt;
    const bool is_number = std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
    return is_number && !inRange(parameter, posh::numberOf(value)) ? std::nullopt : std::optional(value);
}

} // namespace

Result<Value, std::string> convertArgument(const PoshParameter& parameter, const Value& value) {
    if (auto fitting = converted(parameter, value))
        return *std::move(fitting);
    return tl::unexpected("takes $" + parameter.name + " as " + typeText(parameter) + ", not " + posh::toText(value));
}

const PoshParameter* parameterFor(const PrimitiveDescription& primitive, std::size_t position,
                                  const std::string& name) {
    if (name.empty())
        return position < primitive.parameters.size() ? &primitive.parameters[position] : nullptr;
    const auto found = std::ranges::find(primitive.parameters, name, &PoshParameter::name);
    return found == primitive.parameters.end() ? nullptr : &*found;
}

Result<PoshArguments, std::string> PoshArguments::make(const PrimitiveDescription& primitive,
                                                       const std::vector<posh::CallArgument>& arguments) {
    PoshArguments made;
    for (const PoshParameter& parameter : primitive.parameters)
        made.values_.emplace_back(parameter.name, parameter.default_value);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const PoshParameter* const parameter = parameterFor(primitive, i, arguments[i].name);
        if (!parameter)
            return tl::unexpected(
                primitive.name + " takes no " +
                (arguments[i].name.empty() ? "argument " + std::to_string(i + 1) : "$" + arguments[i].name));
        auto value = convertArgument(*parameter, arguments[i].value);
        if (!value)
            return tl::unexpected(primitive.name + " " + value.error());
        made.values_[static_cast<std::size_t>(parameter - primitive.parameters.data())].second = *std::move(value);
    }
    return made;
}

const Value& PoshArguments::find(std::string_view name) const {
    const auto found = std::ranges::find(values_, name, [](const auto& pair) { return std::string_view(pair.first); });
    assert(found != values_.end());
    return found->second;
}

const std::string& PoshArguments::text(std::string_view name) const {
    const Value& value = find(name);
    const auto* const symbol = std::get_if<Symbol>(&value);
    return symbol ? symbol->text : std::get<std::string>(value);
}

PoshRegistry::Entry PoshRegistry::add(PoshPrimitive primitive) {
    const std::string name = primitive.description.name;
    return Entry(primitives_.insert_or_assign(name, std::move(primitive)).first->second.description);
}

const PoshPrimitive* PoshRegistry::find(std::string_view name) const {
    const auto found = primitives_.find(name);
    return found == primitives_.end() ? nullptr : &found->second;
}

std::vector<PrimitiveDescription> PoshRegistry::descriptions() const {
    std::vector<PrimitiveDescription> all;
    for (const auto& [name, primitive] : primitives_)
        all.push_back(primitive.description);
    return all;
}

} // namespace usar::agent
