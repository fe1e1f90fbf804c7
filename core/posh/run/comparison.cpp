#include "core/posh/run/comparison.h"

#include <cmath>
#include <compare>

namespace usar::posh {

namespace {

std::optional<double> asNumber(const Value& value) {
    if (const double* const number = std::get_if<double>(&value))
        return *number;
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    if (const bool* const flag = std::get_if<bool>(&value))
        return *flag ? 1.0 : 0.0;
    return std::nullopt;
}

const std::string* asText(const Value& value) {
    if (const auto* const text = std::get_if<std::string>(&value))
        return text;
    const auto* const symbol = std::get_if<Symbol>(&value);
    return symbol ? &symbol->text : nullptr;
}

bool equal(const Value& a, const Value& b) {
    const auto a_number = asNumber(a);
    const auto b_number = asNumber(b);
    if (a_number && b_number)
        return *a_number == *b_number;
    const std::string* const a_text = asText(a);
    const std::string* const b_text = asText(b);
    if (a_text && b_text)
        return *a_text == *b_text;
    return std::holds_alternative<std::monostate>(a) && std::holds_alternative<std::monostate>(b);
}

/// Returns nullopt for values without an order, such as a number and a text.
std::optional<std::partial_ordering> orderOf(const Value& a, const Value& b) {
    const auto a_number = asNumber(a);
    const auto b_number = asNumber(b);
    if (a_number && b_number)
        return *a_number <=> *b_number;
    const auto* const a_text = std::get_if<std::string>(&a);
    const auto* const b_text = std::get_if<std::string>(&b);
    return a_text && b_text ? std::optional<std::partial_ordering>(*a_text <=> *b_text) : std::nullopt;
}

/// Returns whether a predicate other than Equal and NotEqual holds for two values of this order.
bool isOrdered(std::partial_ordering order, Predicate predicate) {
    return predicate == Predicate::Less          ? order < 0
           : predicate == Predicate::Greater     ? order > 0
           : predicate == Predicate::LessOrEqual ? order <= 0
                                                 : order >= 0;
}

} // namespace

bool truthOf(const Value& answer) {
    if (const auto number = asNumber(answer))
        return *number != 0.0 && !std::isnan(*number);
    if (const auto* const text = std::get_if<std::string>(&answer))
        return !text->empty();
    return std::holds_alternative<Symbol>(answer);
}

Comparison compare(const Value& answer, Predicate predicate, const Value& operand) {
    const auto verdict = [](bool holds) { return holds ? Comparison::Holds : Comparison::Fails; };
    if (predicate == Predicate::Equal || predicate == Predicate::NotEqual)
        return verdict(equal(answer, operand) == (predicate == Predicate::Equal));
    const auto order = orderOf(answer, operand);
    return order ? verdict(isOrdered(*order, predicate)) : Comparison::Unlike;
}

} // namespace usar::posh
