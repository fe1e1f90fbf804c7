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

const Stamped<protocol::NamedRange>* SensorModule::sonar(const std::string& name) const {
    return newest<protocol::SonarReadings>(name);
}

const Stamped<protocol::RangeScan>* SensorModule::scan(const std::string& name) const {
    return newest<protocol::RangeScan>(name);
}

const Stamped<protocol::InsReading>* SensorModule::ins() const {
    return newest<protocol::InsReading>();
}

const Stamped<protocol::GroundTruthReading>* SensorModule::groundTruth() const {
    return newest<protocol::GroundTruthReading>();
}

const Stamped<protocol::OdometryReading>* SensorModule::odometry() const {
    return newest<protocol::OdometryReading>();
}

const Stamped<protocol::EncoderTicks>* SensorModule::encoder(const std::string& name) const {
    return newest<protocol::EncoderReadings>(name);
}

const Stamped<protocol::GenericMessage>* SensorModule::generic(const std::string& type, const std::string& name) const {
    return stores_.of<protocol::GenericMessage>().find(name, type);
}

} // namespace usar::modules
