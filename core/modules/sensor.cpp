#include "core/modules/sensor.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/protocol/fields.h"

namespace usar::modules {

bool hasNews(const protocol::GenericMessage& message) {
    return std::ranges::any_of(message.segments, [&message](const protocol::KeyValue& segment) {
        if (sameWord(segment.key, "Name"))
            return segment.value != message.name; // a grouped segment holds values besides the name
        return !sameWord(segment.key, "Type") && !sameWord(segment.key, "Time");
    });
}

SensorModule::SensorModule() = default;
SensorModule::~SensorModule() = default;

void SensorModule::take(const protocol::InfoLine& line, Seconds now) {
    const Seconds time = protocol::timeOf(line.message).value_or(now);
    forEachSensorReading(line.message, [&]<class Sensor>(std::string_view type, const std::string& name,
                                                         const auto& reading, const Sensor*) {
        if (auto* const place = stores_.of<Sensor>().findOrMake(type, name)) {
            place->value = reading;
            place->time = time;
            place->line = line.number;
        }
    });
}

} // namespace usar::modules
