// Queues every reading of every sensor, by type and name, until it is taken.
#pragma once

#include <cstdint>
#include <list>
#include <string>
#include <vector>

#include "core/modules/sensor_stores.h"

namespace usar::modules {

/// Queued sensor module of the thesis (3.3), for code that decides less often than sensors report but wants every
/// reading. If a sensor has more than `capacity` readings in its queue, the oldest is dropped and counted. A behavior
/// that needs this module owns one and feeds it in `onInfo`.
class QueuedSensorModule {
public:
    static constexpr std::size_t capacity = 4096;

    /// `now` is the time on the protocol's clock, used for readings without a time of their own.
    void take(const protocol::InfoLine& line, Seconds now);

    /// Returns the readings of one sensor, oldest first, and empties its queue. An empty name means the sensor of this
    /// type that reported first.
    template <class Sensor>
    std::vector<Stamped<protocol::ReadingOf<Sensor>>> takeAll(const std::string& name = {}) {
        return emptied(stores_.of<Sensor>().find(name));
    }
    /// The same for a sensor of unknown type; an empty type or name matches any.
    std::vector<Stamped<protocol::GenericMessage>> takeAllGeneric(const std::string& type, const std::string& name) {
        return emptied(stores_.of<protocol::GenericMessage>().find(name, type));
    }
    /// Number of readings lost, of all sensors: dropped from full queues, or of sensors beyond the limit.
    std::uint64_t overflowCount() const { return overflow_count_; }

private:
    template <class Value>
    using Queue = std::list<Stamped<Value>>; // deques of forty types would double the compile time

    template <class Value>
    static std::vector<Stamped<Value>> emptied(Queue<Value>* queue) {
        if (!queue)
            return {};
        std::vector<Stamped<Value>> all(std::make_move_iterator(queue->begin()), std::make_move_iterator(queue->end()));
        queue->clear();
        return all;
    }

    SensorStores<Queue, protocol::SensorTypes> stores_;
    std::uint64_t overflow_count_ = 0;
};

} // namespace usar::modules
