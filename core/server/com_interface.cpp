#include "core/server/com_interface.h"

#include <optional>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/segments.h"
#include "core/protocol/wire_frame.h"

namespace usar::server {

namespace {

/// Reads "1,2,3" (meters in the wire frame) as a point in the map frame; nullopt if it is malformed or not finite.
std::optional<Vec3> readPoint(std::string_view text) {
    Vec3 point = Vec3::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const std::size_t comma = text.find(',');
        const auto number = readNumber(text.substr(0, comma));
        if (!number || (i < 2) != (comma != std::string_view::npos))
            return std::nullopt;
        point[i] = *number;
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    if (!point.allFinite())
        return std::nullopt;
    return protocol::acrossWire(point);
}

std::string writePoint(const Vec3& point_in_map_m) {
    const Vec3 point = protocol::acrossWire(point_in_map_m);
    return fixed(point.x(), 2) + "," + fixed(point.y(), 2) + "," + fixed(point.z(), 2);
}

} // namespace

ComInterface::ComInterface(const sim::Simulation& simulation, RadioField& field, QObject* parent)
    : RequestServer("\r\n", "--cominterface-port", parent)
    , simulation_(simulation)
    , field_(field) {}

std::string ComInterface::answer(int, std::string_view line) {
    Diagnostics diagnostics;
    protocol::Segments segments;
    segments.read(line, diagnostics);
    if (sameWord(segments.typeWord(), "GETPOS"))
        return positions();
    if (!sameWord(segments.typeWord(), "GETOBS"))
        return {};
    return segments.find("From") ? obstacles(segments.value("From"), segments.value("To"))
                                 : obstacles(segments.value("Start"), segments.value("End"));
}

std::string ComInterface::obstacles(std::string_view from, std::string_view to) {
    const auto placeOf = [this](std::string_view text) {
        auto point = readPoint(text);
        if (const sim::RadioStation* const radio = point ? nullptr : field_.station(std::string(text)))
            point = radio->antenna_in_map_m;
        return point;
    };
    const auto from_m = placeOf(from);
    const auto to_m = placeOf(to);
    const int count = from_m && to_m ? simulation_.obstaclesBetween(*from_m, *to_m) : -1;
    return "NUMOBS {From " + std::string(from) + "} {To " + std::string(to) + "} {ObstCount " + std::to_string(count) +
           "}\r\n";
}

std::string ComInterface::positions() {
    const auto& radios = field_.stations();
    const Vec3 up_m(0.0, 0.0, simulation_.options().radio.antenna_height_m);
    std::string line = "POSITIONS {Robots " + std::to_string(radios.size()) + "}";
    for (const sim::RadioStation& radio : radios)
        line += " {Name " + radio.name + " Location " + writePoint(radio.antenna_in_map_m - up_m) + " BatteryEmpty " +
                (radio.silent ? "True" : "False") + "}";
    return line + "\r\n";
}

} // namespace usar::server
