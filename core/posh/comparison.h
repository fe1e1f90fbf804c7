// Truth of a sense's answer, and its comparison with an operand.
#pragma once

#include "core/posh/plan.h"

namespace usar::posh {

/// False for nil, false, 0, 0.0, NaN and the empty string; true for the rest, symbols included.
bool truthOf(const Value& answer);

/// Unlike: the two cannot be ordered, as a number and a text; counts as failing.
enum class Comparison { Fails, Holds, Unlike };

/// Booleans count as 1 and 0, whole numbers as doubles; strings and symbols are equal by their characters; only numbers
/// and two strings (by code point) have an order. Not-a-number differs from everything.
Comparison compare(const Value& answer, Predicate predicate, const Value& operand);

} // namespace usar::posh
