// Finds the known word that a misspelled word was probably meant to be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace usar {

/// Levenshtein distance: the number of bytes to replace, insert or delete to turn one word into the other.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The known word with the smallest edit distance, the first if several are equally near; empty if `known` is empty.
std::string nearestWord(std::string_view word, const std::vector<std::string>& known);

} // namespace usar
