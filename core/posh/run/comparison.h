// The truth of a sense's answer, and its comparison with an operand.
#pragma once

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Returns false for nil, false, 0, 0.0, NaN and the empty string, and true for everything else, including symbols.
bool truthOf(const Value& answer);

/// The result of a comparison. Unlike means that the two values have no order, such as a number and a text; it counts
/// as failing.
enum class Comparison { Fails, Holds, Unlike };

/// Compares `answer` (on the left) with `operand`. Booleans count as 1 and 0, and whole numbers as doubles. A string
/// equals a symbol with the same characters. Only numbers and pairs of strings have an order; strings are ordered by
/// code point. NaN is not equal to anything.
Comparison compare(const Value& answer, Predicate predicate, const Value& operand);

} // namespace usar::posh
