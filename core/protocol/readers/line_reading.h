// The input of the reading functions: one tokenized info line, and the list of its problems.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/base/geometry.h"
#include "core/protocol/schema.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// A key and its value, from a segment of its own or from one of several pairs in a segment. Views into the line.
struct KeyedText {
    std::string_view key;
    std::string_view value;
};

/// The first pair with this key, or with `other_key` unless that is empty, ignoring case; nullptr if there is none.
const KeyedText* findPair(std::span<const KeyedText> pairs, std::string_view key, std::string_view other_key = {});

/// Numbers beyond this are garbage: no sensor value comes near, and the squares of very large numbers overflow.
inline constexpr double largest_plausible = 1e15;
/// False also for NaN.
constexpr bool isPlausible(double value) {
    return value >= -largest_plausible && value <= largest_plausible;
}

/// Converts parts of a line to values and reports those that are invalid. A missing or damaged number is absent, never
/// 0. Created for one line; refers to the caller's `segments`, `diagnostics` and `pairs`, of which the last is a buffer
/// that the caller reuses from line to line.
class LineReading {
public:
    LineReading(const Segments& segments, Diagnostics& diagnostics, std::vector<KeyedText>& pairs)
        : segments_(segments)
        , diagnostics_(diagnostics)
        , pairs_(pairs) {}

    const Segments& segments() const { return segments_; }
    /// All segments in order, except Type and Time. With `split_names`, `{Name F1 Range 4.5}` gives two pairs
    /// (protocol.md 1.4). The result is valid until the next call.
    std::span<const KeyedText> pairs(bool split_names);
    /// Reports a problem; `part`, a view into the line, gives the place. Only the first `most_diagnostics` of a line
    /// are kept, so that a hostile line costs no more than an honest one.
    void warn(std::string_view part, std::string message) { add(Severity::Warning, part, std::move(message)); }
    void error(std::string_view part, std::string message) { add(Severity::Error, part, std::move(message)); }

    /// The number of the first segment with this key. Absent if the key is missing, and, with a warning, if the value
    /// is not a plausible number. Junk after a number only gives a warning, because servers accept the number
    /// (protocol.md 1.6).
    std::optional<double> number(std::string_view key);
    /// The same for a text that the caller has found; it must be a view into the line.
    std::optional<double> numberIn(std::string_view value);
    /// The Time segment, on the server's clock.
    std::optional<Seconds> time();
    /// Reads True, False, 1 or 0, in any case. Absent if the key is missing, and, with a warning, for anything else.
    std::optional<bool> boolean(std::string_view key);

    /// Reads exactly three plausible numbers, in the wire's frame; otherwise reports an error.
    std::optional<Vec3> threeNumbers(std::string_view value);
    /// Converts the texts of a location and an orientation to a pose in our frame, or reports an error.
    std::optional<Pose> pose(std::string_view location, std::string_view orientation);

    static constexpr std::size_t most_diagnostics = 8;

private:
    void add(Severity severity, std::string_view part, std::string message);

    const Segments& segments_;
    Diagnostics& diagnostics_;
    std::vector<KeyedText>& pairs_;
};

/// Reads one member of a message struct from a text, converted to our frame. Returns false, with an error, if the line
/// must stay generic. An invalid number becomes NaN in a double and absent in an optional, with a warning. Members that
/// are not on the line are reset by `clear` instead.
bool take(LineReading& line, std::string_view value, double& member, Crossing crossing);
bool take(LineReading& line, std::string_view value, std::optional<double>& member, Crossing crossing);
bool take(LineReading& line, std::string_view value, long long& member, Crossing);
bool take(LineReading& line, std::string_view value, std::optional<long long>& member, Crossing);
bool take(LineReading& line, std::string_view value, bool& member, Crossing);
bool take(LineReading& line, std::string_view value, std::optional<bool>& member, Crossing);
bool take(LineReading& line, std::string_view value, Present& member, Crossing);
bool take(LineReading& line, std::string_view value, std::string& member, Crossing);
bool take(LineReading& line, std::string_view value, std::optional<std::string>& member, Crossing);
bool take(LineReading& line, std::string_view value, std::optional<Seconds>& member, Crossing);
bool take(LineReading& line, std::string_view value, Vec3& member, Crossing crossing);
bool take(LineReading& line, std::string_view value, std::optional<Vec3>& member, Crossing crossing);
bool take(LineReading& line, std::string_view value, std::optional<Pose>& member, Crossing);
bool take(LineReading& line, std::string_view value, std::vector<double>& member, Crossing);

/// Resets a member to absent, empty or zero, keeping the memory of texts and lists.
template <class Member>
void clear(Member& member) {
    if constexpr (requires { member.clear(); })
        member.clear();
    else if constexpr (requires { member.setZero(); })
        member.setZero();
    else
        member = Member{};
}

/// Removes the next number from a list separated by commas, spaces or both; NaN if the element is not a number. Junk
/// after the number, up to the next separator, is removed with it and makes `clean` false. False at the end of the
/// list.
bool takeNumber(std::string_view& list, double& value, bool& clean);

/// Removes numbers from `text` until `numbers` is full. True if there were enough and all were clean and plausible; any
/// that are missing keep their old values.
bool takeNumbers(std::string_view& text, std::span<double> numbers);

/// Accepts true and false in any case, 1 and 0; nullopt for anything else.
std::optional<bool> readBoolean(std::string_view text);

/// Replaces the content of `numbers` by the comma-separated list in `text`. A comma may follow the last element,
/// because UDK's imagers send one. An element that is not a number, is infinite or is too large for any sensor becomes
/// NaN. Returns how many elements were not clean numbers.
std::size_t readNumberList(std::string_view text, std::vector<double>& numbers);

} // namespace usar::protocol
