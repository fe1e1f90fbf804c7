#include "core/modules/queued_sensor.h"

#include "core/protocol/fields.h"

namespace usar::modules {

void QueuedSensorModule::take(const protocol::InfoLine& line, Seconds now) {
    const Seconds time = protocol::timeOf(line.message).value_or(now);
    forEachSensorReading(line.message, [&]<class Sensor>(std::string_view type, const std::string& name,
                                                         const auto& reading, const Sensor*) {
        auto* const queue = stores_.of<Sensor>().findOrMake(type, name);
        if (!queue || queue->size() >= capacity)
            ++overflow_count_;
        if (!queue)
            return;
        if (queue->size() >= capacity)
            queue->pop_front();
        queue->push_back({reading, time, line.number});
    });
}

} // namespace usar::modules
