#include "core/protocol/command_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/text.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/segments.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

/// One command line and its diagnostics. The functions below give nothing where the line must stay raw.
struct CommandLine {
    const Segments& segments;
    Diagnostics& diagnostics;
    Dialect dialect;

    void warn(std::string_view part, std::string message) const {
        diagnostics.push_back({Severity::Warning, segments.offsetOf(part), std::move(message)});
    }
    std::string text(std::string_view key) const { return std::string(segments.value(key)); }
    std::optional<double> number(std::string_view key) const;
    bool flag(std::string_view key) const;
    bool numbers(const Segment& segment, std::span<double> out) const;
    std::optional<Pose> pose() const;
};

/// As C's atof: the start of the text that is a number, else 0.
std::optional<double> CommandLine::number(std::string_view key) const {
    const Segment* const segment = segments.find(key);
    if (!segment)
        return std::nullopt;
    std::array<double, 1> value{};
    numbers(*segment, value);
    return value[0];
}

bool CommandLine::flag(std::string_view key) const {
    const Segment* const segment = segments.find(key);
    if (!segment)
        return false;
    const std::optional<bool> value = readBoolean(segment->value);
    if (!value)
        warn(segment->text, "neither true nor false; taken as false");
    return value.value_or(false);
}

/// Fills `out`; what is missing or no number is 0. False, with a warning, unless there are exactly as many numbers.
bool CommandLine::numbers(const Segment& segment, std::span<double> out) const {
    std::string_view rest = segment.value;
    const bool good = takeNumbers(rest, out) && trimmed(rest).empty();
    for (double& value : out)
        value = std::isfinite(value) ? value : 0.0;
    if (!good)
        warn(segment.text, "not exactly " + std::to_string(out.size()) + (out.size() == 1 ? " number" : " numbers") +
                               "; taken as far as it goes");
    return good;
}

/// Location and Rotation, each 0,0,0 where absent; nothing without either.
std::optional<Pose> CommandLine::pose() const {
    const Segment* const location = segments.find("Location");
    const Segment* const rotation = segments.find("Rotation");
    if (!location && !rotation)
        return std::nullopt;
    std::array<double, 3> p{};
    std::array<double, 3> angles{};
    if (location)
        numbers(*location, p);
    if (rotation)
        numbers(*rotation, angles);
    return acrossWire(Pose{{p[0], p[1], p[2]}, angles[0], angles[1], angles[2]});
}

std::optional<Command> readInit(const CommandLine& line) {
    Init init;
    init.class_name = line.text("ClassName");
    if (init.class_name.empty()) {
        line.warn(line.segments.line(), "INIT without a ClassName spawns nothing");
        return std::nullopt;
    }
    init.robot_name = line.text("Name");
    if (line.segments.value("Start").empty()) {
        init.start = line.pose().value_or(Pose{});
    } else {
        init.start = line.text("Start");
        init.fallback_in_map = line.pose();
    }
    return init;
}

std::optional<Command> readGetStartPoses(const CommandLine&) {
    return GetStartPoses{};
}

std::optional<double> flipped(std::optional<double> value) {
    return value ? std::optional(acrossWire(*value)) : std::nullopt;
}

AerialDrive readAerialDrive(const CommandLine& line) {
    AerialDrive drive;
    drive.climb_m_s = line.number("AltitudeVelocity");
    drive.forward_m_s = line.number("LinearVelocity");
    drive.left_m_s = flipped(line.number("LateralVelocity"));
    drive.yaw_rate_rad_s = flipped(line.number("RotationalVelocity"));
    drive.normalized = line.flag("Normalized");
    if (drive.yaw_rate_rad_s && line.dialect == Dialect::Udk && !drive.normalized)
        drive.yaw_rate_rad_s = radians(*drive.yaw_rate_rad_s);
    return drive;
}

/// Aerial keys win, for Iridium's stop button sends the keys of all vehicles at once. A bare Normalized is a drive of
/// either kind without terms.
std::optional<Command> readDrive(const CommandLine& line) {
    const Segments& segments = line.segments;
    const auto has = [&segments](std::string_view key) { return segments.find(key) != nullptr; };
    const bool only_normalized = segments.all().size() == 1 && has("Normalized");
    if (has("AltitudeVelocity") || has("LinearVelocity") || has("LateralVelocity") || has("RotationalVelocity") ||
        only_normalized)
        return readAerialDrive(line);
    if (has("Left") || has("Right"))
        return SkidDrive{line.number("Left"), line.number("Right"), line.flag("Normalized")};
    return std::nullopt;
}

template <class Query>
std::optional<Command> readQuery(const CommandLine& line) {
    if (line.segments.value("Type").empty()) {
        line.warn(line.segments.line(), "a question without a Type");
        return std::nullopt;
    }
    return Query{line.text("Type"), line.text("Name")};
}

std::optional<Command> readSet(const CommandLine& line) {
    const Segments& segments = line.segments;
    const Segment* const params = segments.find("Params");
    if (!sameWord(segments.value("Type"), "INS") || !sameWord(segments.value("Opcode"), "POSE"))
        return std::nullopt;
    std::array<double, 6> n{};
    if (!params || !line.numbers(*params, n)) {
        line.warn(segments.line(), "SET INS POSE takes exactly six numbers; ignored");
        return std::nullopt;
    }
    return SetInsPose{line.text("Name"), acrossWire(Pose{{n[0], n[1], n[2]}, n[3], n[4], n[5]})};
}

std::optional<Command> readLockstep(const CommandLine& line) {
    if (!readBoolean(line.segments.value("On"))) {
        line.warn(line.segments.line(), "LOCKSTEP takes {On true} or {On false}");
        return std::nullopt;
    }
    return Lockstep{line.flag("On")};
}

std::optional<Command> readStep(const CommandLine&) {
    return Step{};
}

struct CommandRow {
    std::string_view word;
    std::optional<Command> (*read)(const CommandLine&);
};

constexpr std::array rows = {
    CommandRow{"DRIVE", readDrive},
    CommandRow{"STEP", readStep},
    CommandRow{"SET", readSet},
    CommandRow{"GETGEO", readQuery<GetGeometry>},
    CommandRow{"GETCONF", readQuery<GetConfiguration>},
    CommandRow{"INIT", readInit},
    CommandRow{"GETSTARTPOSES", readGetStartPoses},
    CommandRow{"STARTPOSES", readGetStartPoses},
    CommandRow{"LOCKSTEP", readLockstep},
};

} // namespace

Command readCommand(std::string_view line, Diagnostics& diagnostics, Dialect dialect) {
    Segments segments;
    segments.read(line, diagnostics);
    const auto row =
        std::ranges::find_if(rows, [&](const CommandRow& r) { return sameWord(r.word, segments.typeWord()); });
    std::optional<Command> command;
    if (row != rows.end())
        command = row->read({segments, diagnostics, dialect});
    return command ? std::move(*command) : RawCommand{std::string(line)};
}

} // namespace usar::protocol
