// Where a robot is and how it stands, out of whichever of its sensors says so, and how fast it moves.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/protocol/info_message.h"
#include "widgets/models/heard.h"

namespace usar::widgets {

/// What one sensor says about the pose. Attitude and heading are those of the base in the map frame.
struct PoseSource {
    std::string type; ///< "INS", "GroundTruth", "IMU" or "INU"
    Vec3 roll_pitch_yaw_rad = Vec3::Zero();
    std::optional<Vec3> base_in_map_m{}; ///< absent if the sensor does not tell places
    Heard heard{};
};

/// Speeds over about a second, because places on the wire are whole centimeters.
struct Motion {
    double over_ground_m_s = 0.0; ///< never negative
    double climb_m_s = 0.0;       ///< positive: up
};

/// To be fed with every message of one robot. The INS comes first, because it is what the robot itself believes and
/// what the map shows; then the ground truth, then IMU and INU. A source that has fallen silent yields to one that has
/// not. A plain value without a clock.
class PoseWatch {
public:
    /// `at` is the protocol time of the message. Ignores messages that say nothing about the pose.
    void take(const protocol::InfoMessage& message, Seconds at);

    /// The source of attitude and heading; nullptr if the robot has none.
    const PoseSource* attitude(Seconds now) const;
    /// The source of places; nullptr if the robot has none.
    const PoseSource* place(Seconds now) const;
    /// Out of the places of that source; nullopt until it has told two that are far enough apart in time.
    std::optional<Motion> motion(Seconds now) const;
    /// How much higher than the first place of that source the robot is now, in meters.
    std::optional<double> aboveStart_m(Seconds now) const;

private:
    struct Sample {
        Seconds at;
        Vec3 base_in_map_m;
    };
    struct Track {
        std::optional<PoseSource> source{};
        std::optional<double> first_z_m{};
        std::deque<Sample> samples{}; ///< of the last second or so
    };
    void take(std::size_t rank, const char* type, const Vec3& roll_pitch_yaw_rad, const std::optional<Vec3>& place_m,
              Seconds at);
    /// The first track with a fresh source, else the one that was heard last; `placed`: only those that tell places.
    const Track* best(Seconds now, bool placed) const;

    std::array<Track, 4> tracks_; ///< in order of preference
};

} // namespace usar::widgets
