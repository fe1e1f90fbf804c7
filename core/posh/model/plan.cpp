#include "core/posh/model/plan.h"

#include <array>
#include <cstddef>

#include "core/posh/model/plan_walk.h"

namespace usar::posh {

const Collection* collectionOf(const Plan& plan) {
    for (const Form& form : plan.forms)
        if (const auto* const collection = std::get_if<Collection>(&form))
            return collection;
    return nullptr;
}

bool wantsRealTime(CollectionKind kind) {
    return kind == CollectionKind::Rdc || kind == CollectionKind::Srdc;
}

std::optional<std::int64_t> retryLimit(const Member& element) {
    if (!element.retries)
        return std::nullopt;
    const auto* const count = std::get_if<std::int64_t>(&element.retries->value);
    return count && *count > 0 ? std::optional(*count) : std::nullopt;
}

const Name& nameOf(const Form& form) {
    return std::visit([](const auto& any) -> const Name& { return any.name; }, form);
}

Remarks& remarksOf(Form& form) {
    return std::visit([](auto& any) -> Remarks& { return any.remarks; }, form);
}

const Remarks& remarksOf(const Form& form) {
    return std::visit([](const auto& any) -> const Remarks& { return any.remarks; }, form);
}

const Spot& spotOf(const Form& form) {
    return std::visit([](const auto& any) -> const Spot& { return any.at; }, form);
}

const std::vector<Formal>& formalsOf(const Form& form) {
    static const std::vector<Formal> none;
    const auto* const formals = fieldOf<const std::vector<Formal>>(
        form, [](const auto& any) -> decltype(&any.formals) { return &any.formals; });
    return formals ? *formals : none;
}

const Levels* levelsIn(const Form& form) {
    return fieldOf<const Levels>(form, [](const auto& any) -> decltype(&any.levels) { return &any.levels; });
}

Levels* levelsIn(Form& form) {
    return fieldOf<Levels>(form, [](auto& any) -> decltype(&any.levels) { return &any.levels; });
}

double numberOf(const Value& value) {
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    const auto* const number = std::get_if<double>(&value);
    return number ? *number : 0.0;
}

std::string_view toText(Unit unit) {
    constexpr std::array<std::string_view, 7> words{"hours", "minutes", "seconds", "none", "hz", "pm", "ticks"};
    return words[static_cast<std::size_t>(unit)];
}

std::string_view toText(Predicate predicate) {
    constexpr std::array<std::string_view, 6> words{"==", "!=", "<", ">", "<=", ">="};
    return words[static_cast<std::size_t>(predicate)];
}

} // namespace usar::posh
