// HORN, and one more SET: the one file that new commands take. Nothing else in the tree knows of them.
#pragma once

#include <optional>

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/commands/set_word.h"

namespace usar::protocol {

enum class HornTune { Alarm, Greeting };
template <>
inline constexpr std::array wire_words<HornTune> = {WireWord{"Alarm", HornTune::Alarm},
                                                    WireWord{"Greeting", HornTune::Greeting}};

/// On the wire: `HORN {Tune Greeting} {Pitch 440} {Aim 0.5}`.
struct SoundHorn {
    HornTune tune = HornTune::Alarm;
    std::optional<double> pitch_hz{};
    std::optional<double> aim_rad{}; ///< counterclockwise positive
    bool operator==(const SoundHorn&) const = default;

    static constexpr CommandWord word{"HORN", "sounds the horn", "HORN {Tune Alarm}"};
    static void segments(auto& io, auto& horn) {
        io.choice({"Tune", "the tune to play"}, horn.tune);
        io.number({"Pitch", "Hz"}, horn.pitch_hz);
        io.number({"Aim", "rad; clockwise is positive"}, horn.aim_rad, {.turned = true});
    }
};

/// On the wire: `SET {Type Hatch} {Name Roof} {Opcode LIFT} {Slowly true}`.
struct LiftHatch {
    Name hatch_name{};
    std::optional<bool> slowly{};
    bool operator==(const LiftHatch&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "Hatch");
        io.text(set_name, set.hatch_name);
        io.mark(set_opcode, "LIFT");
        io.flag({"Slowly", "moves at half its speed"}, set.slowly);
    }
};

} // namespace usar::protocol
