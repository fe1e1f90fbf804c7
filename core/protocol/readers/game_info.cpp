#include <array>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/readers/table.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// `name x,y,z r,p,y name …`: a fixed count of numbers behind each name, so that vectors may hold spaces (Gazebo).
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

/// `Name UnitLoader1 Location … Orientation …`, as MOAST knows it.
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

std::optional<InfoMessage> readStartPoses(LineReading& line, const Segment& count) {
    StartPoses result;
    for (const Segment& segment : line.segments().all()) {
        if (segment.text.data() == count.text.data())
            continue;
        const NamedPairs pairs(segment.value);
        const bool named = sameWord(segment.key, "Name") && pairs.name() != segment.value;
        if (!(named ? readNamed(line, pairs, result.poses) : readTriplets(line, segment.text, result.poses)))
            return std::nullopt;
    }
    if (readInteger(count.value) != static_cast<long long>(result.poses.size()))
        line.warn(count.text, "announced '" + std::string(count.value) + "' start poses, sent " +
                                  std::to_string(result.poses.size()));
    return result;
}

std::optional<int> timeLimit(LineReading& line) {
    const std::optional<double> limit_min = line.number("TimeLimit");
    if (!limit_min || std::abs(*limit_min) > 1e9)
        return std::nullopt;
    return static_cast<int>(*limit_min);
}

} // namespace

std::optional<InfoMessage> readGameInfo(LineReading& line) {
    const Segments& segments = line.segments();
    if (const Segment* const count = segments.find("StartPoses"))
        return readStartPoses(line, *count);
    if (segments.find("Lockstep")) {
        const std::optional<bool> on = line.boolean("Lockstep");
        return on ? std::optional<InfoMessage>(LockstepInfo{*on}) : std::nullopt;
    }
    if (!segments.find("Gametype") && !segments.find("Level"))
        return std::nullopt;
    return GameInfo{std::string(segments.value("Gametype")), std::string(segments.value("Level")), timeLimit(line)};
}

} // namespace usar::protocol
