#include <cmath>
#include <string>

#include "core/base/numbers.h"
#include "core/protocol/readers/info_readers.h"
#include "core/protocol/refill.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// Collects the items of a GEO from its segments in order: single items or groups, including the links of a mission
/// package.
class Items {
public:
    Items(LineReading& line, std::vector<MountedItem>& items) : line_(line), items_(items) {}

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
        else if (sameWord(key, "Tip"))
            tip_ = value;
        else if (sameWord(key, "ParentLink") || sameWord(key, "Parent"))
            mount_ = value.starts_with('-') || value == "0" ? base_mount_ : group_ + "_Link" + std::string(value);
    }

    void open(std::string_view name) {
        close();
        group_ = name;
        name_ = name;
        base_mount_ = "HARD";
    }

    /// Call it after the last segment. False if an item was damaged.
    bool finish() {
        close();
        return good_;
    }

private:
    void openLink(std::string_view number) {
        if (name_ == group_ && !location_.empty())
            base_mount_ = group_; // the base of a UDK actuator has a pose of its own
        close();
        name_ = group_ + "_Link" + std::string(number);
    }

    void close() {
        if (!location_.empty() || !orientation_.empty()) {
            const std::optional<Pose> pose = line_.pose(location_, orientation_);
            good_ &= pose.has_value();
            MountedItem& item = items_.next();
            item = {name_, pose.value_or(Pose{}), mount_, std::nullopt};
            if (!tip_.empty())
                good_ &= take(line_, tip_, item.tip_in_item_m, Crossing::Vector);
        }
        location_ = orientation_ = tip_ = {};
        mount_.clear();
    }

    LineReading& line_;
    Refill<MountedItem> items_;
    std::string group_;
    std::string name_;
    std::string mount_;
    std::string base_mount_ = "HARD";
    std::string_view location_;
    std::string_view orientation_;
    std::string_view tip_;
    bool good_ = true;
};

bool readItems(LineReading& line, std::vector<MountedItem>& items) {
    Items collected(line, items);
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
    return collected.finish();
}

/// Reads a vector that may be absent; false if it is there but damaged.
bool readOptional(LineReading& line, std::string_view key, std::optional<Vec3>& vector, Crossing crossing) {
    const Segment* const segment = line.segments().find(key);
    return !segment || take(line, segment->value, vector, crossing);
}

bool readRobot(LineReading& line, GeometryInfo& out) {
    out.robot_class = line.segments().value("Name");
    if (!readOptional(line, "Dimensions", out.dimensions_m, Crossing::None) ||
        !readOptional(line, "COG", out.center_of_gravity_m, Crossing::Vector))
        return false;
    out.wheel_radius_m = line.number("WheelRadius");
    out.wheel_separation_m = line.number("WheelSeparation");
    out.wheel_base_m = line.number("WheelBase");
    return true;
}

std::optional<double> finite(std::optional<double> number) {
    return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Each Status belongs to the thing before it. A thing begins with the first key on the line or the first key after a
/// Status, except ID and Mem.
void readParts(LineReading& line, Response& out) {
    Refill<ResponsePart> parts(out.parts);
    ResponsePart* part = nullptr;
    bool closed = true;
    for (const KeyedText& pair : line.pairs(false)) {
        if (sameWord(pair.key, "Status")) {
            if (part)
                part->ok = sameWord(pair.value, "OK");
            out.ok &= sameWord(pair.value, "OK");
            closed = true;
        } else if (sameWord(pair.key, "FOV")) {
            if (part)
                part->fov_rad = line.numberIn(pair.value);
        } else if (closed && !sameWord(pair.key, "ID") && !sameWord(pair.key, "Mem")) {
            part = &parts.next();
            part->key = pair.key;
            part->value = pair.value;
            part->ok = false;
            part->fov_rad.reset();
            closed = false;
        }
    }
}

} // namespace

bool read(LineReading& line, GeometryInfo& out) {
    const Segments& segments = line.segments();
    if (!segments.find("Type") && !segments.find("Name"))
        return false;
    out = {};
    out.type = segments.value("Type");
    if (out.type.empty() || vehicleKindOf(out.type) != VehicleKind::Unknown || segments.find("Dimensions"))
        return readRobot(line, out);
    return readItems(line, out.items);
}

bool read(LineReading& line, ConfigurationInfo& out) {
    const Segments& segments = line.segments();
    if (!segments.find("Type") && !segments.find("Name"))
        return false;
    out.type = segments.value("Type");
    out.items.clear();
    for (const Segment& segment : segments.all()) {
        if (sameWord(segment.key, "Type"))
            continue;
        if (sameWord(segment.key, "Name")) {
            out.items.push_back({std::string(segment.value), {}});
            continue;
        }
        if (out.items.empty())
            out.items.emplace_back();
        out.items.back().settings.push_back(
            {std::string(segment.key), std::string(segment.value), finite(readNumber(segment.value))});
    }
    return true;
}

bool read(LineReading& line, Response& out) {
    const Segments& segments = line.segments();
    if (!segments.find("Status")) {
        line.error(segments.line(), "a result without Status");
        return false;
    }
    out.time = line.time();
    out.type = segments.value("Type");
    out.name = segments.value("Name");
    out.ok = true;
    readParts(line, out);
    const Segment* const id = segments.find("ID");
    out.tag_id = id ? readInteger(id->value) : std::nullopt;
    const Segment* const memory = segments.find("Mem");
    out.memory = memory ? std::optional<std::string>(memory->value) : std::nullopt;
    return true;
}

} // namespace usar::protocol
