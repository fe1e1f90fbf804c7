// Every reading of every sensor since somebody last looked, by type and name.
#pragma once

#include <cstdint>
#include <list>
#include <string>
#include <utility>
#include <vector>

#include "core/modules/sensor_stores.h"

namespace usar::modules {

/// Queued sensor module of the thesis (3.3), for whoever decides more seldom than sensors speak and wants every
/// reading. Bounded: past `capacity` readings of one sensor the oldest goes and is counted. A behavior that wants it
/// owns one and feeds it in `onInfo`.
class QueuedSensorModule {
public:
    static constexpr std::size_t capacity = 4096;

    /// `now` is the protocol clock, used for readings without a time of their own.
    void take(const protocol::InfoLine& line, Seconds now);

    /// The readings of one sensor, oldest first, which empties its queue. An empty name means the first one that spoke.
    template <class Sensor>
    std::vector<Stamped<protocol::ReadingOf<Sensor>>> takeAll(const std::string& name = {}) {
        return emptied(stores_.of<Sensor>().find(name));
    }
    /// Of a type that no table knows.
    std::vector<Stamped<protocol::GenericMessage>> takeAllGeneric(const std::string& type, const std::string& name) {
        return emptied(generic_.find(name, type));
    }
    /// Readings that fell out of full queues, of all sensors.
    std::uint64_t overflowCount() const { return overflow_count_; }

private:
    template <class Value>
    using Queue = std::list<Stamped<Value>>; // deques of forty kinds would take the compiler twice as long

    template <class Value>
    static std::vector<Stamped<Value>> emptied(Queue<Value>* queue) {
        if (!queue)
            return {};
        std::vector<Stamped<Value>> all(std::make_move_iterator(queue->begin()), std::make_move_iterator(queue->end()));
        queue->clear();
        return all;
    }

    SensorStores<Queue, protocol::SensorTypes> stores_;
    SensorPlaces<Queue<protocol::GenericMessage>> generic_;
    std::uint64_t overflow_count_ = 0;
};

} // namespace usar::modules
