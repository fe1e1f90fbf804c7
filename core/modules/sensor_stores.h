// Building blocks of the sensor modules: a place for each sensor that has reported, by type and name.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/protocol/info_message.h"

namespace usar::modules {

/// A reading with its time (the one it carries, or else the protocol's clock at arrival) and the number of its line.
template <class Value>
struct Stamped {
    Value value;
    Seconds time{0.0};
    /// The info line that the reading came with.
    LineNumber line;
};

/// Places in the order in which the sensors first reported. Types are compared ignoring case, names exactly. At most
/// `most_sensors` sensors get a place; more names than that are garbage.
template <class Content>
class SensorPlaces {
public:
    /// A bound on memory, far above the number of sensors of any robot.
    static constexpr std::size_t most_sensors = 256;

    /// The content kept for one sensor.
    struct Place {
        std::string type;
        std::string name;
        Content content;
    };

    /// The first matching place, nullptr if there is none. An empty name or type matches any.
    const Content* find(std::string_view name, std::string_view type = {}) const {
        const auto place = std::ranges::find_if(places_, [&](const Place& one) {
            return (name.empty() || one.name == name) && (type.empty() || sameWord(one.type, type));
        });
        return place == places_.end() ? nullptr : &place->content;
    }
    /// The same for changes.
    Content* find(std::string_view name, std::string_view type = {}) {
        return const_cast<Content*>(std::as_const(*this).find(name, type));
    }
    /// Returns nullptr if there are too many sensors. Adding a place invalidates the pointers returned before.
    Content* findOrMake(std::string_view type, std::string_view name) {
        const auto place = std::ranges::find_if(
            places_, [&](const Place& one) { return one.name == name && sameWord(one.type, type); });
        if (place != places_.end())
            return &place->content;
        if (places_.size() >= most_sensors)
            return nullptr;
        places_.push_back({std::string(type), std::string(name), {}});
        return &places_.back().content;
    }
    /// All places; a place is never removed.
    const std::vector<Place>& all() const { return places_; }

private:
    std::vector<Place> places_;
};

/// The places for one row of the sensor table. Distinguished by `Sensor`, because two rows may have the same reading
/// type.
template <template <class> class Content, class Sensor>
struct SensorStore {
    SensorPlaces<Content<protocol::ReadingOf<Sensor>>> places;
};

/// A store for each row of the sensor table and one for GenericMessage. `Content<Value>` is the type kept for each
/// sensor. Uses base classes because a tuple of forty elements costs half a second of compile time in every file that
/// includes it.
template <template <class> class Content, class Sensors>
class SensorStores;

template <template <class> class Content, class... Sensors>
class SensorStores<Content, protocol::TypeList<Sensors...>> : private SensorStore<Content, Sensors>...,
                                                              private SensorStore<Content, protocol::GenericMessage> {
public:
    /// The SensorPlaces for one message type.
    template <class Sensor>
    const auto& of() const {
        return static_cast<const SensorStore<Content, Sensor>&>(*this).places;
    }
    /// The same for changes, for the owner of the store.
    template <class Sensor>
    auto& of() {
        return static_cast<SensorStore<Content, Sensor>&>(*this).places;
    }
};

/// True if a line of an unknown sensor has data besides Type, Time and Name. UDK sends lines without data.
bool hasNews(const protocol::GenericMessage& message);

/// Calls `file(type, name, reading, tag)` for every reading in the message; `tag` is a null pointer to the message
/// type, by which the caller selects the store. Lines of unknown sensors and damaged lines are passed as
/// GenericMessage.
template <class File>
void forEachSensorReading(const protocol::InfoMessage& message, File&& file) {
    std::visit(
        [&file]<class Message>(const Message& one) {
            if constexpr (protocol::SensorMessage<Message>)
                protocol::forEachReading(one, [&](const std::string& name, const auto& reading) {
                    file(protocol::wireTypeOf(one), name, reading, static_cast<const Message*>(nullptr));
                });
            else if constexpr (std::is_same_v<Message, protocol::GenericMessage>)
                if (sameWord(one.type_word, "SEN") && hasNews(one))
                    file(std::string_view(one.type), one.name, one, static_cast<const Message*>(nullptr));
        },
        message);
}

} // namespace usar::modules
