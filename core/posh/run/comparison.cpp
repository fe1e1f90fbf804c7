#include "core/posh/run/comparison.h"

#include <cmath>

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

Comparison verdict(bool holds) {
    return holds ? Comparison::Holds : Comparison::Fails;
}

template <class T>
Comparison ordered(const T& a, Predicate predicate, const T& b) {
    switch (predicate) {
    case Predicate::Less:
        return verdict(a < b);
    case Predicate::Greater:
        return verdict(a > b);
    case Predicate::LessOrEqual:
        return verdict(a <= b);
    default:
        return verdict(a >= b);
    }
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
    if (predicate == Predicate::Equal)
        return verdict(equal(answer, operand));
    if (predicate == Predicate::NotEqual)
        return verdict(!equal(answer, operand));
    const auto a = asNumber(answer);
    const auto b = asNumber(operand);
    if (a && b)
        return ordered(*a, predicate, *b);
    const auto* const a_text = std::get_if<std::string>(&answer);
    const auto* const b_text = std::get_if<std::string>(&operand);
    if (a_text && b_text)
        return ordered(*a_text, predicate, *b_text);
    return Comparison::Unlike;
}

} // namespace usar::posh
