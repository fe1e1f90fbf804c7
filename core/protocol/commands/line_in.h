// Reads the values of one command line: the visitor of T::segments that fills a command.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/protocol/commands/object_motion.h"
#include "core/protocol/commands/segment_values.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// Is as tolerant as a server: accepts keys in any case, uses the first of several equal keys, and reads numbers by
/// their beginning. A missing value leaves optionals, flags and enumerations as they are and refuses the line
/// otherwise; a refused line becomes a RawCommand. Converts positions, angles and turns from the wire's frame to ours.
/// Created for one line.
class LineIn : private SegmentValues {
public:
    static constexpr bool reading = true;
    static constexpr bool writing = false;

    /// Both references must outlive this object. Warnings and the reason for a refusal go to `diagnostics`.
    LineIn(const Segments& segments, Diagnostics& diagnostics, Dialect dialect)
        : SegmentValues(segments, diagnostics)
        , dialect_(dialect) {}
    /// True as soon as one value refused the line; the command that is being filled must not be used then.
    using SegmentValues::refused;
    Dialect dialect() const { return dialect_; }

    /// Does nothing, because the reader chose the command by this mark. The second form gives what its word stands for.
    void mark(const Key&, std::string_view, std::string_view = {}) {}
    template <class Value, std::size_t count>
    void mark(const Key& key, Value& value, const std::array<WireWord<Value>, count>& table) {
        if (const Segment* const segment = find(key))
            value = meaningOf(*segment, table);
    }
    void ignored(const Key&) {}

    /// Reads a number; leaves an optional unchanged if there is no such segment. Angles sent in degrees become radians,
    /// turns change their sign. A keyless number is looked for in the whole text of every segment. Whole numbers refuse
    /// the line if they have a fraction or are beyond 1e9.
    void number(const Key& key, std::optional<double>& value, NumberForm form = {});
    void number(const Key& key, std::optional<int>& value, NumberForm = {});
    void number(const Key& key, std::optional<Seconds>& value, NumberForm = {});
    template <class Number>
    void number(const Key& key, Number& value, NumberForm form = {}) {
        std::optional<Number> read;
        number(key, read, form);
        take(key, read, value);
    }
    /// Reads whether the speeds that follow are in percent; these are limited to -100..100, with a warning.
    void beginScale(bool& normalized);
    void endScale() {}

    void flag(const Key& key, std::optional<bool>& value);
    void flag(const Key& key, bool& value);
    void digit(const Key& key, std::optional<bool>& value) { flag(key, value); }
    /// Refuses the line if the value is missing or not a boolean.
    void neededFlag(const Key& key, bool& value);

    template <TextRule rule>
    void text(const Key& key, CheckedText<rule>& value) {
        takeText(key, segments().value(key), value);
    }
    /// Refuses the line if the word is unknown.
    template <class Value>
    void choice(const Key& key, Value& value) {
        mark(key, value, wire_words<Value>);
    }
    template <class Value>
    void choice(const Key& key, std::optional<Value>& value) {
        if (find(key))
            choice(key, value.emplace());
    }

    /// Three numbers in the wire's frame; `position` converts them, or the angles of an orientation, to ours.
    void vector(const Key& key, std::optional<Vec3>& value);
    void vector(const Key& key, Vec3& value);
    void position(const Key& key, Vec3& value);
    void position(const Key& key, std::optional<Vec3>& value);
    /// Reads Location and Rotation, each 0,0,0 if absent.
    void pose(Pose& pose) { pose = poseOnLine().value_or(Pose{}); }
    /// Reads the name of a start pose and the pose beside it, or else a pose.
    void start(const Key& key, std::variant<Pose, Token>& start, std::optional<Pose>* fallback = nullptr);
    /// Refuses the line unless there are exactly six numbers.
    void sixNumbers(const Key& key, Pose& pose);
    void goal(const Key& point_key, const Key& node_key, std::variant<Vec2, Token>& goal);
    /// Reads points separated by semicolons; refuses the line unless each has exactly three numbers. A missing list is
    /// empty.
    void points(const Key& key, std::vector<Vec3>& points);
    /// Refuses the line if only one of the corners is there.
    void box(const Key& min_key, const Key& max_key, std::optional<Box>& box);
    void pace(const Key& speed_key, const Key& time_key, std::variant<WaypointSpeed, Seconds>& pace);
    /// Reads one number, or, if there is a comma, a number and a steering angle, which is clockwise positive on the
    /// wire.
    void valueAndSteer(const Key& key, double& value, std::optional<double>& steer_rad);
    void tagAndText(const Key& key, Token& tag, Text& text);

    /// Reads elements that each begin with a segment `first`. The segments after it apply to that element, and the last
    /// of several equal ones counts.
    template <class Element>
    void groups(const Key& first, std::vector<Element>& elements) {
        for (const Segment& segment : segments().all()) {
            Element stray;
            if (sameWord(segment.key, first))
                elements.emplace_back();
            only_ = &segment;
            only_is_known_ = false;
            Element::segments(*this, elements.empty() ? stray : elements.back());
            if (elements.empty() && only_is_known_)
                refuse(segment.text, std::string(segment.key) + " stands before the first " + std::string(first));
        }
        only_ = nullptr;
    }
    /// Reads every segment as a joint and its angle.
    template <class Target>
    void joints(std::span<const Key>, std::vector<Target>& targets) {
        for (const Segment& segment : segments().all()) {
            Target target{"?"};
            takeText("joint", segment.key, target.joint);
            target.angle_rad = numberOf(segment);
            targets.push_back(std::move(target));
        }
    }

private:
    /// The segment with this key, or nullptr; within a group only the segment at hand is considered.
    const Segment* find(std::string_view key);
    /// Refuses the line for a missing value, except within a group, where each segment is offered by itself.
    template <class Value>
    void take(const Key& key, const std::optional<Value>& read, Value& value) {
        if (read)
            value = *read;
        else if (!only_)
            refuseWithout(key);
    }
    std::optional<Pose> poseOnLine();

    Dialect dialect_;
    const Segment* only_ = nullptr; ///< the one segment that counts while an element of a group is read
    bool only_is_known_ = false;    ///< the element has looked for that segment
    bool normalized_ = false;
};

} // namespace usar::protocol
