#include <string>
#include <utility>

#include "core/protocol/readers/table.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// Collects the items of a GEO while its segments go by, grouped or single, links of a mission package among them.
class Items {
public:
    explicit Items(LineReading& line) : line_(line) {}

    void takePair(std::string_view key, std::string_view value) {
        if (sameWord(key, "Location"))
            location_ = value;
        else if (sameWord(key, "Orientation"))
            orientation_ = value;
        else if (sameWord(key, "Mount"))
            mount_ = value;
        else if (sameWord(key, "MountLink"))
            mount_ += "_Link" + std::string(value);
        else if (sameWord(key, "Link"))
            openLink(value);
        else if (sameWord(key, "ParentLink") || sameWord(key, "Parent"))
            mount_ = value.starts_with('-') || value == "0" ? base_mount_ : group_ + "_Link" + std::string(value);
    }

    void open(std::string_view name) {
        close();
        group_ = name;
        name_ = name;
        base_mount_ = "HARD";
    }

    /// False when an item was damaged.
    bool finish(std::vector<MountedItem>& items) {
        close();
        items = std::move(items_);
        return good_;
    }

private:
    void openLink(std::string_view number) {
        if (name_ == group_ && !location_.empty())
            base_mount_ = group_; // UDK's actuators have a base with a pose of its own
        close();
        name_ = group_ + "_Link" + std::string(number);
    }

    void close() {
        if (!location_.empty() || !orientation_.empty()) {
            const std::optional<Pose> pose = line_.pose(location_, orientation_);
            good_ &= pose.has_value();
            items_.push_back({name_, pose.value_or(Pose{}), mount_});
        }
        location_ = orientation_ = {};
        mount_.clear();
    }

    LineReading& line_;
    std::vector<MountedItem> items_;
    std::string group_;
    std::string name_;
    std::string mount_;
    std::string base_mount_ = "HARD";
    std::string_view location_;
    std::string_view orientation_;
    bool good_ = true;
};

bool readItems(LineReading& line, std::vector<MountedItem>& items) {
    Items collected(line);
    for (const Segment& segment : line.segments().all()) {
        if (!sameWord(segment.key, "Name")) {
            collected.takePair(segment.key, segment.value);
            continue;
        }
        NamedPairs pairs(segment.value);
        collected.open(pairs.name());
        std::string_view key;
        std::string_view value;
        while (pairs.next(key, value))
            collected.takePair(key, value);
    }
    return collected.finish(items);
}

/// A vector that may be absent; false when it is there and damaged.
bool readOptional(LineReading& line, std::string_view key, std::optional<Vec3>& vector) {
    const Segment* const segment = line.segments().find(key);
    if (segment)
        vector = line.threeNumbers(segment->value);
    return !segment || vector;
}

std::optional<InfoMessage> readRobot(LineReading& line, GeometryInfo result) {
    result.robot_class = line.segments().value("Name");
    std::optional<Vec3> center_on_wire_m;
    if (!readOptional(line, "Dimensions", result.dimensions_m) || !readOptional(line, "COG", center_on_wire_m))
        return std::nullopt;
    if (center_on_wire_m)
        result.center_of_gravity_m = acrossWire(*center_on_wire_m);
    result.wheel_radius_m = line.number("WheelRadius");
    result.wheel_separation_m = line.number("WheelSeparation");
    result.wheel_base_m = line.number("WheelBase");
    return result;
}

} // namespace

std::optional<InfoMessage> readGeometry(LineReading& line) {
    const Segments& segments = line.segments();
    if (!segments.find("Type") && !segments.find("Name"))
        return std::nullopt;
    GeometryInfo result;
    result.type = segments.value("Type");
    if (result.type.empty() || vehicleKindOf(result.type) != VehicleKind::Unknown || segments.find("Dimensions"))
        return readRobot(line, std::move(result));
    if (!readItems(line, result.items))
        return std::nullopt;
    return result;
}

} // namespace usar::protocol
