#include "core/modules/queued_sensor.h"

#include "core/protocol/fields.h"

namespace usar::modules {

void QueuedSensorModule::take(const protocol::InfoLine& line, Seconds now) {
    const Seconds time = protocol::timeOf(line.message).value_or(now);
    forEachSensorReading(line.message, [&]<class Sensor>(std::string_view type, const std::string& name,
                                                         const auto& reading, const Sensor*) {
        const auto file = [&](auto& places) {
            auto* const queue = places.findOrMake(type, name);
            if (!queue) {
                ++overflow_count_;
                return;
            }
            if (queue->size() >= capacity) {
                queue->pop_front();
                ++overflow_count_;
            }
            queue->push_back({reading, time, line.number});
        };
        if constexpr (std::is_same_v<Sensor, protocol::GenericMessage>)
            file(generic_);
        else
            file(stores_.of<Sensor>());
    });
}

} // namespace usar::modules
