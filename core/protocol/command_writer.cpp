#include "core/protocol/command_writer.h"

#include <initializer_list>
#include <string_view>
#include <utility>

#include "core/base/numbers.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

class CommandLine {
public:
    explicit CommandLine(std::string_view word) : text_(word) {}

    CommandLine& segment(std::string_view key, std::string_view value) {
        text_ += " {";
        text_.append(key);
        text_ += ' ';
        for (const char c : value) {
            if (c != '{' && c != '}' && static_cast<unsigned char>(c) >= ' ')
                text_ += c;
        }
        text_ += '}';
        return *this;
    }
    CommandLine& optionalSegment(std::string_view key, const std::optional<double>& value) {
        if (value)
            segment(key, shortest({*value}));
        return *this;
    }
    CommandLine& flag(std::string_view key, bool value) { return segment(key, value ? "true" : "false"); }

    static std::string shortest(std::initializer_list<double> values) {
        std::string text;
        for (const double value : values) {
            if (!text.empty())
                text += ',';
            appendShortest(text, value);
        }
        return text;
    }

    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void addPose(CommandLine& line, const Pose& pose_in_map) {
    const Pose on_wire = acrossWire(pose_in_map);
    const Vec3& p = on_wire.position_m;
    line.segment("Location", CommandLine::shortest({p.x(), p.y(), p.z()}));
    line.segment("Rotation", CommandLine::shortest({on_wire.roll_rad, on_wire.pitch_rad, on_wire.yaw_rad}));
}

std::string question(std::string_view word, const std::string& type, const std::string& name) {
    CommandLine line(word);
    line.segment("Type", type);
    if (!name.empty())
        line.segment("Name", name);
    return line.take();
}

std::string text(const RawCommand& raw, Dialect) {
    return raw.line;
}

std::string text(const Init& init, Dialect) {
    CommandLine line("INIT");
    line.segment("ClassName", init.class_name);
    if (!init.robot_name.empty())
        line.segment("Name", init.robot_name);
    if (const std::string* name = std::get_if<std::string>(&init.start)) {
        line.segment("Start", *name);
        if (init.fallback_in_map)
            addPose(line, *init.fallback_in_map);
    } else {
        addPose(line, std::get<Pose>(init.start));
    }
    return line.take();
}

std::string text(const GetStartPoses&, Dialect) {
    return "GETSTARTPOSES";
}

std::string text(const AerialDrive& drive, Dialect dialect) {
    const auto flipped = [](std::optional<double> value) {
        return value ? std::optional(acrossWire(*value)) : std::nullopt;
    };
    std::optional<double> yaw_rate = flipped(drive.yaw_rate_rad_s);
    if (yaw_rate && dialect == Dialect::Udk && !drive.normalized)
        yaw_rate = degrees(*yaw_rate);
    return CommandLine("DRIVE")
        .optionalSegment("AltitudeVelocity", drive.climb_m_s)
        .optionalSegment("LinearVelocity", drive.forward_m_s)
        .optionalSegment("LateralVelocity", flipped(drive.left_m_s))
        .optionalSegment("RotationalVelocity", yaw_rate)
        .flag("Normalized", drive.normalized)
        .take();
}

std::string text(const SkidDrive& drive, Dialect) {
    return CommandLine("DRIVE")
        .optionalSegment("Left", drive.left_rad_s)
        .optionalSegment("Right", drive.right_rad_s)
        .flag("Normalized", drive.normalized)
        .take();
}

std::string text(const GetGeometry& query, Dialect) {
    return question("GETGEO", query.type, query.name);
}

std::string text(const GetConfiguration& query, Dialect) {
    return question("GETCONF", query.type, query.name);
}

std::string text(const SetInsPose& set, Dialect) {
    const Pose on_wire = acrossWire(set.base_in_map);
    const Vec3& p = on_wire.position_m;
    return CommandLine("SET")
        .segment("Type", "INS")
        .segment("Name", set.sensor_name)
        .segment("Opcode", "POSE")
        .segment("Params",
                 CommandLine::shortest({p.x(), p.y(), p.z(), on_wire.roll_rad, on_wire.pitch_rad, on_wire.yaw_rad}))
        .take();
}

std::string text(const Lockstep& lockstep, Dialect) {
    return CommandLine("LOCKSTEP").flag("On", lockstep.on).take();
}

std::string text(const Step&, Dialect) {
    return "STEP";
}

} // namespace

std::string write(const Command& command, Dialect dialect) {
    return std::visit([dialect](const auto& value) { return text(value, dialect); }, command);
}

} // namespace usar::protocol
