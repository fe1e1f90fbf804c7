#include "core/protocol/readers/table.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

template <class Reading>
std::optional<InfoMessage> readLocationAndOrientation(LineReading& line) {
    const Segment* const location = line.segments().find("Location");
    const Segment* const orientation = line.segments().find("Orientation");
    if (!location && !orientation)
        return std::nullopt;
    if (!location || !orientation) {
        line.error(line.segments().line(), "a pose needs Location and Orientation");
        return std::nullopt;
    }
    const std::optional<Pose> pose = line.pose(location->value, orientation->value);
    if (!pose)
        return std::nullopt;
    return Reading{line.time(), std::string(line.segments().value("Name")), *pose};
}

} // namespace

std::optional<InfoMessage> readIns(LineReading& line) {
    return readLocationAndOrientation<InsReading>(line);
}

std::optional<InfoMessage> readGroundTruth(LineReading& line) {
    return readLocationAndOrientation<GroundTruthReading>(line);
}

std::optional<InfoMessage> readOdometry(LineReading& line) {
    const Segment* const segment = line.segments().find("Pose");
    const std::optional<Vec3> pose = segment ? line.threeNumbers(segment->value) : std::nullopt;
    if (!pose)
        return std::nullopt;
    OdometryReading result;
    result.base_in_start = acrossWire(Pose{.position_m = {pose->x(), pose->y(), 0.0}, .yaw_rad = pose->z()});
    result.time = line.time();
    result.name = line.segments().value("Name");
    return result;
}

} // namespace usar::protocol
