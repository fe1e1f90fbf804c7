#include "core/posh/run/comparison.h"

#include <cmath>

namespace usar::posh {

namespace {

const double* asNumber(const Value& value, double& buffer) {
    if (const double* const number = std::get_if<double>(&value))
        return number;
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
        return buffer = static_cast<double>(*whole), &buffer;
    if (const bool* const flag = std::get_if<bool>(&value))
        return buffer = *flag ? 1.0 : 0.0, &buffer;
    return nullptr;
}

const std::string* asText(const Value& value) {
    if (const auto* const text = std::get_if<std::string>(&value))
        return text;
    const auto* const symbol = std::get_if<Symbol>(&value);
    return symbol ? &symbol->text : nullptr;
}

bool equal(const Value& a, const Value& b) {
    double a_buffer = 0.0;
    double b_buffer = 0.0;
    const double* const a_number = asNumber(a, a_buffer);
    const double* const b_number = asNumber(b, b_buffer);
    if (a_number && b_number)
        return *a_number == *b_number;
    const std::string* const a_text = asText(a);
    const std::string* const b_text = asText(b);
    if (a_text && b_text)
        return *a_text == *b_text;
    return std::holds_alternative<std::monostate>(a) && std::holds_alternative<std::monostate>(b);
}

template <class T>
bool ordered(const T& a, Predicate predicate, const T& b) {
    switch (predicate) {
    case Predicate::Less:
        return a < b;
    case Predicate::Greater:
        return a > b;
    case Predicate::LessOrEqual:
        return a <= b;
    default:
        return a >= b;
    }
}

Comparison verdict(bool holds) {
    return holds ? Comparison::Holds : Comparison::Fails;
}

} // namespace

bool truthOf(const Value& answer) {
    double buffer = 0.0;
    if (const double* const number = asNumber(answer, buffer))
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
    double answer_buffer = 0.0;
    double operand_buffer = 0.0;
    const double* const a = asNumber(answer, answer_buffer);
    const double* const b = asNumber(operand, operand_buffer);
    if (a && b)
        return verdict(ordered(*a, predicate, *b));
    const auto* const a_text = std::get_if<std::string>(&answer);
    const auto* const b_text = std::get_if<std::string>(&operand);
    if (a_text && b_text)
        return verdict(ordered(*a_text, predicate, *b_text));
    return Comparison::Unlike;
}

} // namespace usar::posh
