#include <array>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/readers/info_readers.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// Reads `name x,y,z r,p,y name …`. Takes six numbers after each name, so that vectors may contain spaces (Gazebo).
bool readTriplets(LineReading& line, std::string_view text, std::vector<StartPose>& poses) {
    for (std::string_view name = takeWord(text); !name.empty(); name = takeWord(text)) {
        std::array<double, 6> n;
        if (!takeNumbers(text, n)) {
            line.error(name, "the start pose '" + std::string(name) + "' needs six numbers");
            return false;
        }
        poses.push_back({std::string(name), acrossWire(Pose{{n[0], n[1], n[2]}, n[3], n[4], n[5]})});
    }
    return true;
}

/// Reads `Name UnitLoader1 Location … Orientation …`, the form that MOAST expects.
bool readNamed(LineReading& line, NamedPairs pairs, std::vector<StartPose>& poses) {
    std::string_view location;
    std::string_view orientation;
    std::string_view key;
    std::string_view value;
    while (pairs.next(key, value)) {
        if (sameWord(key, "Location"))
            location = value;
        else if (sameWord(key, "Orientation") || sameWord(key, "Rotation"))
            orientation = value;
    }
    if (location.empty() || orientation.empty()) {
        line.error(pairs.name(), "a start pose needs Location and Orientation");
        return false;
    }
    const std::optional<Pose> pose = line.pose(location, orientation);
    if (pose)
        poses.push_back({std::string(pairs.name()), *pose});
    return pose.has_value();
}

/// Reads all segments except the one with the count. Warns if the count differs from the number of places, which `what`
/// names in the plural.
bool readPlaces(LineReading& line, std::string_view count_key, std::string_view what, std::vector<StartPose>& poses) {
    poses.clear();
    const Segment* const count = line.segments().find(count_key);
    for (const Segment& segment : line.segments().all()) {
        if (&segment == count)
            continue;
        const NamedPairs pairs(segment.value);
        const bool named = sameWord(segment.key, "Name") && pairs.name() != segment.value;
        if (!(named ? readNamed(line, pairs, poses) : readTriplets(line, segment.text, poses)))
            return false;
    }
    if (readInteger(count->value) != static_cast<long long>(poses.size()))
        line.warn(count->text, "announced '" + std::string(count->value) + "' " + std::string(what) + ", sent " +
                                   std::to_string(poses.size()));
    return true;
}

std::optional<int> timeLimit(LineReading& line) {
    const std::optional<double> limit_min = line.number("TimeLimit");
    if (!limit_min || std::abs(*limit_min) > 1e9)
        return std::nullopt;
    return static_cast<int>(*limit_min);
}

} // namespace

bool read(LineReading& line, StartPoses& out) {
    return readPlaces(line, "StartPoses", "start poses", out.poses);
}

bool read(LineReading& line, PathNodes& out) {
    return readPlaces(line, "PathNodes", "path nodes", out.nodes);
}

bool read(LineReading& line, ClosestPathNode& out) {
    out.name = line.segments().value("Pathnode");
    const std::optional<Vec3> on_wire_m = line.threeNumbers(line.segments().value("Location"));
    if (on_wire_m)
        out.position_in_map_m = acrossWire(*on_wire_m);
    return on_wire_m.has_value();
}

bool read(LineReading& line, LockstepInfo& out) {
    const std::optional<bool> on = line.boolean("Lockstep");
    out.on = on.value_or(false);
    return on.has_value();
}

bool read(LineReading& line, GameInfo& out) {
    const Segments& segments = line.segments();
    if (!segments.find("Gametype") && !segments.find("Level"))
        return false;
    out.game_type = segments.value("Gametype");
    out.level = segments.value("Level");
    out.time_limit_min = timeLimit(line);
    return true;
}

} // namespace usar::protocol
