// What a reading function works on: one tokenised info line, and the list of what is wrong with it.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/base/geometry.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Turns pieces of a line into values and complains about what is no value. A missing or damaged number is absent,
/// never 0. Poses and positions come out in our frame. Lives as long as one line is read.
class LineReading {
public:
    LineReading(const Segments& segments, Diagnostics& diagnostics) : segments_(segments), diagnostics_(diagnostics) {}

    const Segments& segments() const { return segments_; }
    /// `part` is a view into the line; it says where.
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

private:
    const Segments& segments_;
    Diagnostics& diagnostics_;
};

/// Cuts the next number off a list separated by commas, spaces or both. NaN where the element is no number; the text
/// behind it, up to the next separator, goes with it and makes `clean` false. False at the end of the list.
bool takeNumber(std::string_view& list, double& value, bool& clean);

/// Takes numbers off `text` until `numbers` is full; true when it is, and every one was clean and finite.
bool takeNumbers(std::string_view& text, std::span<double> numbers);

/// true, True, TRUE, 1 and their opposites.
std::optional<bool> readBoolean(std::string_view text);

} // namespace usar::protocol
