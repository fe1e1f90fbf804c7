// What a reading function works on: one tokenised info line, and the list of what is wrong with it.
#pragma once

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

/// A key and its value, out of a segment or out of several pairs in one.
struct KeyedText {
    std::string_view key;
    std::string_view value;
};

/// The first pair with this key, or with the other one where it is not empty; nullptr without.
const KeyedText* findPair(std::span<const KeyedText> pairs, std::string_view key, std::string_view other_key = {});

/// Larger numbers are garbage: nothing that is sensed comes near, and their squares are infinite.
inline constexpr double largest_plausible = 1e15;
constexpr bool isPlausible(double value) {
    return value >= -largest_plausible && value <= largest_plausible;
}

/// Turns pieces of a line into values and complains about what is no value. A missing or damaged number is absent,
/// never 0. Poses and positions come out in our frame. Lives as long as one line is read. `pairs` is room to be reused.
class LineReading {
public:
    LineReading(const Segments& segments, Diagnostics& diagnostics, std::vector<KeyedText>& pairs)
        : segments_(segments)
        , diagnostics_(diagnostics)
        , pairs_(pairs) {}

    const Segments& segments() const { return segments_; }
    /// All segments in order but Type and Time. With `split_names`, `{Name F1 Range 4.5}` gives two pairs (1.4).
    std::span<const KeyedText> pairs(bool split_names);
    /// `part` is a view into the line; it says where. Beyond `most_diagnostics` of a line nothing is added: a hostile
    /// line must not cost more than an honest one.
    void warn(std::string_view part, std::string message);
    void error(std::string_view part, std::string message);

    /// The number of the first segment with this key. Absent without a word when the key is missing; with a warning
    /// when its value is no finite number. Junk behind a number is a warning, as servers take the number (1.6).
    std::optional<double> number(std::string_view key);
    /// The same for text that was found otherwise.
    std::optional<double> numberIn(std::string_view value);
    std::optional<Seconds> time();
    /// True, False, 1, 0 in any case; a warning for anything else.
    std::optional<bool> boolean(std::string_view key);

    /// Exactly three finite numbers, as they are on the wire; else an error.
    std::optional<Vec3> threeNumbers(std::string_view value);
    /// Location and orientation texts to a pose in our frame; else an error.
    std::optional<Pose> pose(std::string_view location, std::string_view orientation);

    static constexpr std::size_t most_diagnostics = 8;

private:
    void add(Severity severity, std::string_view part, std::string message);

    const Segments& segments_;
    Diagnostics& diagnostics_;
    std::vector<KeyedText>& pairs_;
};

/// Text to one member of a container, across the frames; false, with an error, when the line must stay generic. Absent
/// values are made so by `clear`.
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

template <class Member>
void clear(Member& member) {
    if constexpr (requires { member.clear(); })
        member.clear();
    else if constexpr (requires { member.setZero(); })
        member.setZero();
    else
        member = Member{};
}

/// Cuts the next number off a list separated by commas, spaces or both. NaN where the element is no number; the text
/// behind it, up to the next separator, goes with it and makes `clean` false. False at the end of the list.
bool takeNumber(std::string_view& list, double& value, bool& clean);

/// Takes numbers off `text` until `numbers` is full; true when it is, and every one was clean and finite.
bool takeNumbers(std::string_view& text, std::span<double> numbers);

/// true, True, TRUE, 1 and their opposites.
std::optional<bool> readBoolean(std::string_view text);

} // namespace usar::protocol
