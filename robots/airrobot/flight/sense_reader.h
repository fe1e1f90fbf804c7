// Computes the senses of the robot from what the server has told.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/mapping/beam_hits.h"
#include "core/mapping/level_flight.h"
#include "core/modules/robot_modules.h"
#include "robots/airrobot/flight/pose_estimate.h"
#include "robots/airrobot/flight/reading_checks.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/flight/sensor_layout.h"

namespace usar::airrobot {

/// Computes the senses from the modules' snapshots. A reading is new if its line differs from that of the last tick.
/// Ages count from the tick that saw a reading, so they are at most one tick too small. Owned by one robot.
class SenseReader {
public:
    /// Returns the senses of a tick; call it once per tick. A sonar that has sent no number for longer than `time_out`
    /// counts as silent.
    Senses read(Seconds now, LineNumber line, const modules::RobotModules& robot, const SensorLayout& layout,
                Seconds time_out);
    /// Sets the robot's last command: its velocity over ground (robot frame) and its rate of climb, which is 0
    /// where the robot may be unable to obey it (see Told).
    void tellCommand(const Vec2& velocity_in_base_m_s, double climb_m_s = 0.0) {
        commanded_m_s_ = velocity_in_base_m_s;
        commanded_climb_m_s_ = climb_m_s;
    }
    /// Sets the velocity relative to the air (robot frame) that was commanded last, with which the course is compared;
    /// nullopt where the robot may be unable to obey it.
    void tellDrive(const std::optional<Vec2>& through_air_in_base_m_s) { through_air_m_s_ = through_air_in_base_m_s; }
    /// Corrects the heading by the course from the next tick on, or leaves it as the INS tells it.
    void correctHeading(bool correct) { corrects_heading_ = correct; }
    /// Places the beams of the scanner from the next tick on as a robot leans in steady flight, or as the INS tells it.
    void correctLean(bool correct) { corrects_lean_ = correct; }
    /// Sets whether there is wind: it makes the robot lean, which then is no sign of drift.
    void tellWind(bool wind) { wind_ = wind; }
    /// Takes the pose from ground truth instead of the INS from the next tick on.
    void navigateByTruth(bool truth) { by_truth_ = truth; }
    /// Forgets velocities and the heading correction, because the position estimate has jumped.
    void forgetMotion();

private:
    /// The last line with a number from one sonar, the time at which it was received, and the range to believe then.
    struct Heard {
        LineNumber line;
        Seconds at{0.0};
        double range_m = 0.0;
    };

    /// Takes the pose if the reading is a new one that can be believed.
    template <class Reading>
    void readPose(Seconds now, const Reading* reading);
    /// Places the echoes; notes which sonars are silent and the age of the oldest reading.
    void readSonars(Senses& senses, const modules::RobotModules& robot, const SensorLayout& layout, Seconds time_out);
    /// Places a new scan and finds the ground in it; between scans the last ground is kept.
    void readScan(Senses& senses, const modules::RobotModules& robot, const SensorLayout& layout);

    bool by_truth_ = false;
    bool corrects_heading_ = true;
    bool corrects_lean_ = false;
    bool wind_ = false;
    PoseHistory history_;
    PoseHistory told_history_; ///< with the heading as it was told
    mapping::LevelFlight level_flight_;
    CourseFilter course_;
    PoseCheck pose_check_;
    ScanCheck scan_check_;
    mapping::BeamDirections beam_directions_;
    SonarCheck sonar_check_;
    Vec2 commanded_m_s_ = Vec2::Zero(); ///< robot frame
    double commanded_climb_m_s_ = 0.0;
    std::optional<Vec2> through_air_m_s_; ///< robot frame
    /// The pose of the last INS reading, with corrected yaw; kept while no new one comes.
    Pose base_in_map_;
    double flown_m_ = 0.0; ///< since the estimate jumped
    LineNumber last_ins_;
    LineNumber last_scan_;
    std::optional<Seconds> ins_seen_;
    std::optional<Seconds> scan_seen_;
    std::map<std::string, Heard, std::less<>> sonars_heard_;
    /// The ground below by the last scan; kept until the next scan.
    std::optional<double> ground_m_;
};

} // namespace usar::airrobot
