#include "core/base/numbers.h"
#include "core/protocol/readers/named_values.h"
#include "core/protocol/readers/table.h"

namespace usar::protocol {

std::optional<InfoMessage> readEncoders(LineReading& line) {
    EncoderReadings result;
    result.time = line.time();
    bool whole = true;
    forEachNamedValue(line.segments(), "Tick", [&](std::string_view name, std::string_view value) {
        const std::optional<long long> ticks = readInteger(value);
        if (ticks)
            result.encoders.push_back({std::string(name), *ticks});
        else
            line.error(value, "ticks are a whole number");
        whole &= ticks.has_value();
    });
    return whole && !result.encoders.empty() ? std::optional<InfoMessage>(std::move(result)) : std::nullopt;
}

} // namespace usar::protocol
