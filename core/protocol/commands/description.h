// The parts of which a command describes itself. Reader, writer, grammar, completion and help all follow from them.
//
// A command is a struct in this folder and an entry of CommandVariant (core/protocol/command.h). Beside its values it
// has
// - `word`: the first word of its line, with help, as a CommandWord. Several commands may share one.
// - `segments(io, command)`: passes each segment of the line to `io`, in the order of the wire, with its key, its help
//   and the member that holds its value. LineOut writes the line, LineIn reads the values, and LineRules lists the
//   keys.
// - `signs`, if the word alone does not tell which command it is: keys of which the line has at least one. `weak_signs`
//   count only if no other command of this word has a sign on the line; an empty one is a line without segments. Marks,
//   which are segments whose value is one fixed word, need no sign.
// A line is read as the first command in CommandVariant whose word, marks and signs it has.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace usar::protocol {

/// The first word of a line, a phrase of help, and a complete line as an example. All texts are static.
struct CommandWord {
    std::string_view word;
    std::string_view help;
    std::string_view example;
    std::string_view other_word{}; ///< understood like `word`, but never written
    bool drives = false;           ///< moves the robot until the next command with this word
};

/// The key of a segment and a phrase of help. `words` are the usual values of a text, offered for completion.
struct Key {
    /// The texts are not copied and must be static.
    constexpr Key(const char* key, std::string_view help_text = {}, std::span<const std::string_view> usual = {})
        : name(key)
        , help(help_text)
        , words(usual) {}
    explicit constexpr Key(std::string_view key) : name(key) {}
    /// A key passes for its name wherever only that matters.
    constexpr operator std::string_view() const { return name; }

    std::string_view name;
    std::string_view help{};
    std::span<const std::string_view> words{};
};

/// Keys or words as an array.
template <class... Texts>
constexpr std::array<std::string_view, sizeof...(Texts)> texts(Texts... texts) {
    return {texts...};
}

inline constexpr Key location_key{"Location", "x,y,z in meters; z is down"};
inline constexpr Key rotation_key{"Rotation", "roll,pitch,yaw in radians; yaw is clockwise"};
inline constexpr Key normalized_key{"Normalized", "true: values are percent of the maximum, -100..100"};

/// How a number on the wire differs from ours.
struct NumberForm {
    bool turned = false;  ///< a sideways or turning value, whose sign changes
    bool scaled = false;  ///< in percent if the command is normalized, then limited to -100..100
    bool degrees = false; ///< degrees on the wire, radians here
    bool or_zero = false; ///< written as 0 if it is absent
    bool keyless = false; ///< also understood without its key: {0.5}
};

/// A word on the wire and the value that it stands for.
template <class Value>
struct WireWord {
    std::string_view word;
    Value value;
};
template <class Value>
WireWord(std::string_view, Value) -> WireWord<Value>; // Clang 14 cannot deduce it without this guide

/// The words of an enumeration, stated beside it. The first word for a value is the one we write; UDK compares some of
/// them case-sensitively.
template <class Value>
inline constexpr auto wire_words = nullptr;

} // namespace usar::protocol
