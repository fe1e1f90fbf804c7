// Writes the segments of one command line: the visitor of T::segments that makes text of a command.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/numbers.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/commands/object_motion.h"
#include "core/protocol/dialect.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

/// Writes no segment for an absent or empty value, and 0 for NaN and infinity, which is how a server would read them.
/// Converts positions, angles and turns from our frame to the wire's. Vectors have commas and no spaces; numbers read
/// back as the same double. The text belongs to the caller and must outlive this object.
class LineOut {
public:
    static constexpr bool reading = false;
    static constexpr bool writing = true;

    /// Appends to `out`, which already has the command's word; each segment begins with a blank.
    LineOut(std::string& out, Dialect dialect) : out_(out), dialect_(dialect) {}
    Dialect dialect() const { return dialect_; }

    /// Writes a segment with one fixed word, or the word for a value.
    void mark(const Key& key, std::string_view word, std::string_view = {}) {
        open(key);
        out_.append(word);
        close();
    }
    template <class Value, std::size_t count>
    void mark(const Key& key, Value value, const std::array<WireWord<Value>, count>& table) {
        mark(key, std::ranges::find(table, value, &WireWord<Value>::value)->word);
    }
    /// Writes nothing.
    void ignored(const Key&) {}

    /// Writes a number in the form that the server expects: degrees instead of radians, the opposite sign for a turn,
    /// limited to -100..100 for a speed in percent, and 0 for an absent value if the form says so.
    void number(const Key& key, const std::optional<double>& value, NumberForm form = {});
    void number(const Key& key, const std::optional<Seconds>& value) {
        if (value)
            number(key, value->count());
    }
    /// States whether the speeds that follow are in percent; `endScale` writes this flag.
    void beginScale(bool normalized) { normalized_ = normalized; }
    void endScale() { flag(normalized_key, normalized_); }

    void flag(const Key& key, const std::optional<bool>& value) {
        if (value)
            mark(key, *value ? "true" : "false");
    }
    void neededFlag(const Key& key, bool value) { flag(key, value); }
    /// A flag that is sent as 1 or 0 instead of true or false.
    void digit(const Key& key, const std::optional<bool>& value) {
        if (value)
            mark(key, *value ? "1" : "0");
    }
    /// Writes a text as it is; its type guarantees that it has no braces.
    void text(const Key& key, std::string_view value) {
        if (!value.empty())
            mark(key, value);
    }
    /// Writes the first word in the enumeration's table that stands for the value.
    template <class Value>
    void choice(const Key& key, const std::optional<Value>& value) {
        if (value)
            choice(key, *value);
    }
    template <class Value>
    requires std::is_enum_v<Value>
    void choice(const Key& key, Value value) { mark(key, value, wire_words<Value>); }

    /// Writes the vector unchanged; `position` converts it.
    void vector(const Key& key, const std::optional<Vec3>& value);
    void position(const Key& key, const Vec3& value) { vector(key, acrossWire(value)); }
    void position(const Key& key, const std::optional<Vec3>& value) {
        if (value)
            position(key, *value);
    }
    /// Writes Location and Rotation.
    void pose(const Pose& pose);
    /// Writes a pose, or the name of a start pose and the pose to take if there is no such name.
    void start(const Key& key, const std::variant<Pose, Token>& start, const std::optional<Pose>* fallback = nullptr);
    /// Writes x, y, z, roll, pitch and yaw as one list.
    void sixNumbers(const Key& key, const Pose& pose);
    /// Writes x and y of a point, or the name of a path node.
    void goal(const Key& point_key, const Key& node_key, const std::variant<Vec2, Token>& goal);
    /// Writes points separated by semicolons.
    void points(const Key& key, const std::vector<Vec3>& points);
    /// Writes two corners. y and z change their signs on the wire, so that their minimum and maximum swap.
    void box(const Key& min_key, const Key& max_key, const std::optional<Box>& box);
    /// Writes either a speed in m/s or a time in seconds.
    void pace(const Key& speed_key, const Key& time_key, const std::variant<WaypointSpeed, Seconds>& pace);
    /// Writes a number and, after a comma, a steering angle if there is one.
    void valueAndSteer(const Key& key, double value, const std::optional<double>& steer_rad);
    /// Writes the tag and, after a blank, the text if there is any.
    void tagAndText(const Key& key, const Token& tag, const Text& text);

    /// Writes the segments of each element, one after the other.
    template <class Element>
    void groups(const Key&, const std::vector<Element>& elements) {
        for (const Element& element : elements)
            Element::segments(*this, element);
    }
    /// Writes a segment for each joint, with the joint's name as its key.
    template <class Target>
    void joints(std::span<const Key>, const std::vector<Target>& targets) {
        for (const Target& target : targets)
            number(Key(target.joint), target.angle_rad);
    }

private:
    void open(std::string_view key) {
        out_ += " {";
        out_.append(key);
        out_ += ' ';
    }
    void close() { out_ += '}'; }
    void add(double value) { appendShortest(out_, finite(value)); }
    void add(const Vec3& value);
    /// Also turns -0 into 0.
    static double finite(double value) { return std::isfinite(value) ? value + 0.0 : 0.0; }

    std::string& out_;
    Dialect dialect_;
    bool normalized_ = false;
};

} // namespace usar::protocol
