#include "core/protocol/readers/number_list.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"
#include "core/base/plain_decimal.h"
#include "core/base/text.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

namespace {

/// Reads an element that is not a plain decimal, up to its comma.
double readOddElement(const char*& at, const char* end, std::size_t& doubtful) {
    const char* const stop = std::find(at, end, ',');
    const std::string_view element = trimmed({at, static_cast<std::size_t>(stop - at)});
    at = stop;
    const NumberPrefix prefix = readNumberPrefix(element);
    const bool plausible = isPlausible(prefix.value);
    if (prefix.used != element.size() || !plausible || element.empty())
        ++doubtful;
    return prefix.used == 0 || !plausible ? std::numeric_limits<double>::quiet_NaN() : prefix.value;
}

} // namespace

std::size_t readNumberList(std::string_view text, std::vector<double>& numbers) {
    numbers.clear();
    text = trimmed(text);
    if (text.ends_with(','))
        text.remove_suffix(1);
    if (text.empty())
        return 0;
    std::size_t doubtful = 0;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        const char* const start = at;
        double number = 0.0;
        if (!readPlainDecimal(at, end, number) || (at != end && *at != ',')) {
            at = start;
            number = readOddElement(at, end, doubtful);
        }
        numbers.push_back(number);
        if (at == end)
            return doubtful;
        ++at;
    }
}

} // namespace usar::protocol
