#include "core/modules/sensor.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/fields.h"
#include "core/protocol/segments.h"

namespace usar::modules {

namespace {

/// A head alone means "no news" (UDK) and must not replace a reading.
bool hasNews(const protocol::GenericMessage& message) {
    return std::ranges::any_of(message.segments, [&message](const protocol::KeyValue& segment) {
        if (protocol::sameWord(segment.key, "Name"))
            return segment.value != message.name; // a grouped one holds values beside the name
        return !protocol::sameWord(segment.key, "Type") && !protocol::sameWord(segment.key, "Time");
    });
}

template <class Map>
const typename Map::mapped_type* lookUp(const Map& map, const typename Map::key_type& key) {
    const auto found = map.find(key);
    return found == map.end() ? nullptr : &found->second;
}

} // namespace

void SensorModule::take(const protocol::InfoLine& line, Seconds now) {
    arrival_ = {protocol::timeOf(line.message).value_or(now), line.number};
    std::visit([this](const auto& message) { file(message); }, line.message);
}

void SensorModule::file(const protocol::SonarReadings& message) {
    for (const protocol::NamedRange& sonar : message.ranges)
        sonars_.insert_or_assign(sonar.name, stamped(sonar));
}

void SensorModule::file(const protocol::RangeScan& message) {
    if (scans_.empty())
        first_scanner_ = message.name;
    scans_.insert_or_assign(message.name, stamped(message));
}

void SensorModule::file(const protocol::InsReading& message) {
    ins_ = stamped(message);
}

void SensorModule::file(const protocol::GroundTruthReading& message) {
    ground_truth_ = stamped(message);
}

void SensorModule::file(const protocol::OdometryReading& message) {
    if (message.base_in_start)
        odometry_ = stamped(message);
}

void SensorModule::file(const protocol::EncoderReadings& message) {
    for (const protocol::EncoderTicks& encoder : message.encoders)
        encoders_.insert_or_assign(encoder.name, stamped(encoder));
}

void SensorModule::file(const protocol::GenericMessage& message) {
    if (protocol::sameWord(message.type_word, "SEN") && hasNews(message))
        generic_.insert_or_assign(std::pair(lowerCase(message.type), message.name), stamped(message));
}

const Stamped<protocol::NamedRange>* SensorModule::sonar(const std::string& name) const {
    return lookUp(sonars_, name);
}

const Stamped<protocol::RangeScan>* SensorModule::scan(const std::string& name) const {
    return lookUp(scans_, name.empty() ? first_scanner_ : name);
}

const Stamped<protocol::EncoderTicks>* SensorModule::encoder(const std::string& name) const {
    return lookUp(encoders_, name);
}

const Stamped<protocol::GenericMessage>* SensorModule::generic(const std::string& type, const std::string& name) const {
    return lookUp(generic_, std::pair(lowerCase(type), name));
}

} // namespace usar::modules
