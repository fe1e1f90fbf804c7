#include <limits>
#include <utility>

#include "core/base/numbers.h"
#include "core/protocol/readers/named_values.h"
#include "core/protocol/readers/table.h"

namespace usar::protocol {

std::optional<InfoMessage> readSonars(LineReading& line) {
    SonarReadings result;
    result.time = line.time();
    result.ranges.reserve(line.segments().all().size());
    forEachNamedValue(line.segments(), "Range", [&](std::string_view name, std::string_view value) {
        const std::optional<double> range_m = line.numberIn(value);
        result.ranges.push_back({std::string(name), range_m.value_or(std::numeric_limits<double>::quiet_NaN())});
    });
    return result.ranges.empty() ? std::nullopt : std::optional<InfoMessage>(std::move(result));
}

} // namespace usar::protocol
