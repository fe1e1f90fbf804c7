// What sensor modules are made of: a place for each sensor that has spoken, by type and name.
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

/// A reading and when it came: its own time where it carries one, else the clock at arrival.
template <class Value>
struct Stamped {
    Value value;
    Seconds time{0.0};
    LineNumber line;
};

/// In the order in which the sensors first spoke. The type in any case, the name exactly. Names beyond `most_sensors`
/// are garbage and get no place.
template <class Content>
class SensorPlaces {
public:
    static constexpr std::size_t most_sensors = 256;

    struct Place {
        std::string type;
        std::string name;
        Content content;
    };

    /// nullptr where there is none; an empty name or type stands for any.
    const Content* find(std::string_view name, std::string_view type = {}) const {
        const auto place = std::ranges::find_if(places_, [&](const Place& one) {
            return (name.empty() || one.name == name) && (type.empty() || sameWord(one.type, type));
        });
        return place == places_.end() ? nullptr : &place->content;
    }
    Content* find(std::string_view name, std::string_view type = {}) {
        return const_cast<Content*>(std::as_const(*this).find(name, type));
    }
    /// nullptr when there are too many.
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
    const std::vector<Place>& all() const { return places_; }

private:
    std::vector<Place> places_;
};

/// The places of one row of the table; by the sensor's type, as two sensors may have the same reading.
template <template <class> class Content, class Sensor>
struct SensorStore {
    SensorPlaces<Content<protocol::ReadingOf<Sensor>>> places;
};

/// A store for each row of the table of sensors. `Content<Value>` is what is kept of one sensor. Bases and no tuple: a
/// tuple of forty takes the compiler half a second wherever it is seen.
template <template <class> class Content, class Sensors>
class SensorStores;

template <template <class> class Content, class... Sensors>
class SensorStores<Content, protocol::TypeList<Sensors...>> : private SensorStore<Content, Sensors>... {
public:
    template <class Sensor>
    const auto& of() const {
        return static_cast<const SensorStore<Content, Sensor>&>(*this).places;
    }
    template <class Sensor>
    auto& of() {
        return static_cast<SensorStore<Content, Sensor>&>(*this).places;
    }
};

/// Of a line that is no known sensor's: whether it tells anything. A bare head means "no news" (UDK).
bool hasNews(const protocol::GenericMessage& message);

/// Calls `file(type, name, reading, tag)` for every reading in the message; `tag` points to the sensor's type. Lines of
/// sensors that no table knows, and damaged ones, come as themselves.
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
