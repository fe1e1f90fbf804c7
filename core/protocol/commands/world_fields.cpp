#include "core/protocol/commands/world_fields.h"

#include "core/base/text.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

void fields(LineIn& in, KillAllObjects& kill) {
    std::optional<Vec3> min_m;
    std::optional<Vec3> max_m;
    in.vector("MinPos", min_m);
    in.vector("MaxPos", max_m);
    if (min_m && max_m)
        kill.within = acrossWire(Box{*min_m, *max_m});
    else if (min_m || max_m)
        in.refuse(in.segments().line(), "KillAll takes both MinPos and MaxPos, or neither");
}

void fields(LineIn& in, AddWaypoints& add) {
    in.text("Name", add.object_name);
    std::string_view rest = in.segments().value("WP");
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        std::string_view point = rest.substr(0, end);
        std::array<double, 3> numbers{};
        if (!takeNumbers(point, numbers) || !trimmed(point).empty())
            return in.refuse(rest, "a way point is not three numbers");
        add.points_in_map_m.push_back(acrossWire(Vec3(numbers[0], numbers[1], numbers[2])));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

void pace(LineIn& in, std::variant<WaypointSpeed, Seconds>& pace) {
    if (in.segments().find("Speed"))
        in.number("Speed", std::get<WaypointSpeed>(pace).speed_m_s);
    else
        in.seconds("Time", pace.emplace<Seconds>(0.0));
}

} // namespace usar::protocol
