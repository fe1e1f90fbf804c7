// SEN messages about the surroundings: Sound, Acoustic, CO2Sensor, MissionTime, ObjectSensor, and Helper, which sees
// the soccer ball. `time` is on the server's clock; absent optionals were not on the line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The sound at the sensor's place.
/// On the wire: `SEN {Time 1} {Type Sound} {Name S} {Loudness 12.5} {Duration 3.25}`.
struct SoundReading {
    std::optional<Seconds> time{};
    std::string name{};
    double loudness_db = 0.0;
    std::optional<Seconds> duration{}; ///< length of the sound

    static constexpr std::string_view wire_types = "Sound";
    static constexpr bool speaks_always = false;
    static constexpr auto items() {
        return std::tuple(
            item("Loudness", &SoundReading::loudness_db, "loudness", "dB", Crossing::None, Decimals::TwoRounded),
            item("Duration", &SoundReading::duration, "duration", "s", Crossing::None, Decimals::TwoRounded));
    }
    bool operator==(const SoundReading&) const = default;
};

/// A sound heard by UDK's acoustic sensor: too far away to be located, or with a unit vector toward it in the sensor's
/// frame.
struct HeardSound {
    /// Yes if the line has {Far} instead of a direction.
    Present far = Present::No;
    std::optional<Vec3> direction{};   ///< absent if the sound is too far away
    std::optional<double> volume{};    ///< as sent; no unit is known
    std::optional<Seconds> duration{}; ///< length of the sound
    /// As sent; no source says between which moments.
    std::optional<Seconds> delay{};

    static constexpr auto items() {
        return std::tuple(item("Far", &HeardSound::far, "far"),
                          item("Direction", &HeardSound::direction, "direction", "", Crossing::Vector),
                          item("Volume", &HeardSound::volume, "volume"),
                          item("Duration", &HeardSound::duration, "duration", "s"),
                          item("Delay", &HeardSound::delay, "delay", "s"));
    }
    bool operator==(const HeardSound&) const = default;
};

/// The sounds heard at one moment. `silence` is Yes if the server sent {None}.
/// On the wire: `SEN {Time 1} {Type Acoustic} {Name A} {Direction 0,1,0} {Volume 0.5} {Duration 1.5} {Delay 0.25}`.
struct AcousticReading {
    std::optional<Seconds> time{};
    std::string name{};
    Present silence = Present::No;
    /// One element for each Direction or Far on the line; empty in silence.
    std::vector<HeardSound> sounds{};

    static constexpr std::string_view wire_types = "Acoustic";
    static constexpr bool speaks_always = false;
    static constexpr auto items() { return std::tuple(item("None", &AcousticReading::silence, "silence")); }
    static constexpr auto groups() { return protocol::groups("Direction", &AcousticReading::sounds, "Far"); }
    bool operator==(const AcousticReading&) const = default;
};

/// The concentration of one gas at the sensor's place.
/// On the wire: `SEN {Time 1} {Type CO2Sensor} {Name C} {Gas CO2} {Density 0.25}`.
struct GasReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// The gas by its name, such as CO2.
    std::string gas{};
    double density = 0.0; ///< as sent; no source gives its unit

    static constexpr std::string_view wire_types = "CO2Sensor";
    static constexpr auto items() {
        return std::tuple(item("Gas", &GasReading::gas, "gas"),
                          item("Density", &GasReading::density, "density", "", Crossing::None, Decimals::TwoRounded));
    }
    bool operator==(const GasReading&) const = default;
};

/// The place at which the camera of a soccer robot sees the ball (thesis 5.2). The axes are those of the camera's
/// picture, so the numbers stay as they are on the wire: forward, right and down. The thesis tells of a place and a
/// radius in the picture, too; their keys are ours, because no source gives them (robots-and-worlds.md 3.4).
/// On the wire: `SEN {Type Helper} {Name b} {Pos3D 1.2,0.1,0} {Visible true} {Pos2D 0.15,0} {Radius 0.08}`.
struct BallReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<Vec3> position{};
    /// False if the ball is out of sight.
    std::optional<bool> visible{};
    /// Right of and below the middle of the picture, from -1 to 1 at its edges; empty if not sent.
    std::vector<double> place_in_picture{};
    std::optional<double> radius_in_picture{}; ///< share of half the picture's width

    static constexpr std::string_view wire_types = "Helper";
    static constexpr bool speaks_always = false;
    static constexpr auto items() {
        return std::tuple(item("Pos3D", &BallReading::position, "position"),
                          item("Visible", &BallReading::visible, "visible"),
                          item("Pos2D", &BallReading::place_in_picture, "place_in_picture"),
                          item("Radius", &BallReading::radius_in_picture, "radius_in_picture"));
    }
    bool operator==(const BallReading&) const = default;
};

/// The mission's time in whole minutes.
/// On the wire: `SEN {Time 33} {Type MissionTime} {Name c} {Minutes 2}`.
struct MissionTimeReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// A line without Minutes is no such reading.
    long long minutes = 0;

    static constexpr std::string_view wire_types = "MissionTime";
    static constexpr auto items() {
        return std::tuple(item("Minutes", &MissionTimeReading::minutes, "minutes", "min"));
    }
    bool operator==(const MissionTimeReading&) const = default;
};

/// One object seen by an ObjectSensor.
struct SeenObject {
    std::string tag{}; ///< value of Object
    /// From Location and Orientation, in our map frame.
    Pose object_in_map{};
    std::optional<Vec3> hit_in_map_m{}; ///< point at which the sensor's ray hits the object
    std::string material{};             ///< "None" if it has none

    static constexpr auto items() {
        return std::tuple(item("Object", &SeenObject::tag, "tag"), pose(&SeenObject::object_in_map),
                          item("HitLoc", &SeenObject::hit_in_map_m, "hit", "m", Crossing::Vector, Decimals::TwoRounded),
                          item("Material", &SeenObject::material, "material"));
    }
    bool operator==(const SeenObject&) const = default;
};

/// All objects that the sensor sees at one moment.
/// On the wire: `SEN {Time 34} {Type ObjectSensor} {Name o} {Object Box1} {Location 3,1,1.5} {Orientation 0,0,1.5}`.
struct ObjectsReading {
    std::optional<Seconds> time{};
    std::string name{};
    /// In the order of the line; empty if the line names none.
    std::vector<SeenObject> objects{};

    static constexpr std::string_view wire_types = "ObjectSensor";
    static constexpr bool speaks_always = false;
    static constexpr auto groups() { return protocol::groups("Object", &ObjectsReading::objects); }
    bool operator==(const ObjectsReading&) const = default;
};

} // namespace usar::protocol
