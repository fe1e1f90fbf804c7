// SEN messages of sensors that detect people: VictSensor, VictRFID, HumanMotion and GroundTruthPlayers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// A detected body part: Head, Arm, Hand, Chest, Pelvis, Leg or Foot. May be a false alarm.
struct SeenPart {
    std::string part{};
    std::optional<Vec3> part_in_sensor_m{}; ///< position in the sensor's frame

    static constexpr auto items() {
        return std::tuple(item("PartName", &SeenPart::part, "part"), item("Location", &SeenPart::part_in_sensor_m, "",
                                                                          "m", Crossing::Vector, Decimals::TwoRounded));
    }
    bool operator==(const SeenPart&) const = default;
};

/// The body parts in view, sent every fourth tick. Without victims it has a status instead ("NoVictims"), and sometimes
/// no name.
/// On the wire: `SEN {Time 1} {Type VictSensor} {Name V} {PartName Leg} {Location 2,0.25,0.5}`.
struct VictimReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// In the order of the line; several parts may belong to one person.
    std::vector<SeenPart> parts{};
    /// Absent if parts are in view.
    std::optional<std::string> status{};

    static constexpr std::string_view wire_types = "VictSensor";
    static constexpr bool speaks_always = false;
    static constexpr auto items() { return std::tuple(item("Status", &VictimReading::status, "status")); }
    static constexpr auto groups() { return protocol::groups("PartName", &VictimReading::parts); }
    bool operator==(const VictimReading&) const = default;
};

/// A victim with a radio tag. `id` is text; "None" if the tag is too far away to be read.
struct TaggedVictim {
    std::string id{};
    std::string victim_name{}; ///< sent by some versions only
    /// Free text about the victim, such as "ok"; empty if it was not sent.
    std::string status{};
    std::optional<Vec3> victim_in_reader_m{}; ///< position in the reader's frame

    static constexpr auto items() {
        return std::tuple(
            item("ID", &TaggedVictim::id, "id", "", Crossing::None, Decimals::FourCut, "VictimId"),
            item("VictimName", &TaggedVictim::victim_name, "name"),
            item("Status", &TaggedVictim::status, "status", "", Crossing::None, Decimals::FourCut, "VictimStatus"),
            item("Location", &TaggedVictim::victim_in_reader_m, "", "m", Crossing::Vector, Decimals::TwoRounded));
    }
    bool operator==(const TaggedVictim&) const = default;
};

/// All tagged victims in reach of the reader.
/// On the wire: `SEN {Time 1} {Type VictRFID} {Name V} {ID Becky} {Status ok} {Location 3,2,-1}`.
struct VictimTagReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// In the order of the line; a tag that cannot be read is listed, too.
    std::vector<TaggedVictim> victims{};

    static constexpr std::string_view wire_types = "VictRFID";
    static constexpr bool speaks_always = false;
    static constexpr auto groups() { return protocol::groups("ID", &VictimTagReading::victims, "VictimId"); }
    bool operator==(const VictimTagReading&) const = default;
};

/// The probability that a person moves within the sensor's view.
/// On the wire: `SEN {Time 1} {Type HumanMotion} {Name H} {Prob 0.25}`.
struct HumanMotionReading {
    std::optional<Seconds> time{};
    std::string name{};
    double probability = 0.0; ///< 0..1

    static constexpr std::string_view wire_types = "HumanMotion";
    static constexpr bool speaks_always = false;
    static constexpr auto items() {
        return std::tuple(
            item("Prob", &HumanMotionReading::probability, "probability", "", Crossing::None, Decimals::TwoRounded));
    }
    bool operator==(const HumanMotionReading&) const = default;
};

/// One player of the game. `position_uu` is its position in Unreal's own frame and units.
struct Player {
    /// The game's number of the player.
    long long number = 0;
    std::string anchor{};
    std::optional<bool> is_player{};
    /// In our map frame, converted from the wire's.
    std::optional<Vec3> player_in_map_m{};
    std::optional<Vec3> position_uu{};

    static constexpr auto items() {
        return std::tuple(
            item("PlayerNum", &Player::number, "number"), item("Anchor", &Player::anchor, "anchor"),
            item("IsPlayer", &Player::is_player, "is_player"),
            item("Location", &Player::player_in_map_m, "", "m", Crossing::Vector, Decimals::TwoRounded),
            item("UTLocation", &Player::position_uu, "position_uu", "", Crossing::None, Decimals::TwoRounded));
    }
    bool operator==(const Player&) const = default;
};

/// All players of the game; `count` is the number that the server announced.
/// On the wire: `SEN {Type GroundTruthPlayers} {Name P} {Players 1} {PlayerNum 4} {Anchor None} {IsPlayer True}`.
struct PlayersReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<long long> count{};
    /// In the order of the line.
    std::vector<Player> players{};

    static constexpr std::string_view wire_types = "GroundTruthPlayers";
    static constexpr bool speaks_always = false;
    static constexpr auto items() { return std::tuple(item("Players", &PlayersReading::count, "count")); }
    static constexpr auto groups() { return protocol::groups("PlayerNum", &PlayersReading::players); }
    bool operator==(const PlayersReading&) const = default;
};

} // namespace usar::protocol
