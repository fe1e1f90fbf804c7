// Tells readings from what a faulty sensor or link makes of them, before they move the robot.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/protocol/sensors/range_scan.h"

namespace usar::airrobot {

/// What the robot was told to do when a reading came.
struct Told {
    double speed_m_s = 0.0; ///< level
    double climb_m_s = 0.0; ///< positive upward; 0 where the robot may be unable to climb or sink, as on the ground
};

/// Judges the poses of one sensor. Lines that lose bytes on their way make poses leap, and a sensor that hangs repeats
/// the last one. Owned by one robot.
class PoseCheck {
public:
    /// Returns whether this is where the robot is. Call it for each new reading. A pose that is too far from the last
    /// one is not believed until three in a row agree. A pose that repeats itself to the last digit although the robot
    /// is told to move shows that the sensor hangs. That pose is never believed again, and others are only when three
    /// in a row differ from it, because a damaged line differs from it, too.
    bool believes(Seconds now, const Pose& pose_in_map, const Told& told);
    /// True if the last pose was not believed and its lean had leapt.
    bool leanLeapt() const { return lean_leapt_; }
    /// Forgets all poses, because the estimate has jumped.
    void forget() { *this = {}; }

private:
    bool hangs(Seconds now, const Pose& pose_in_map, const Told& told);
    bool leaps(Seconds now, const Pose& pose_in_map);

    struct Believed {
        Seconds at{0.0};
        Pose pose_in_map;
    };
    std::optional<Believed> last_;
    std::optional<Pose> hung_at_; ///< the pose that a hanging sensor repeats
    bool hanging_ = false;
    int others_ = 0;                        ///< poses in a row that differ from that one
    std::optional<Seconds> vertical_since_; ///< when the pose began to repeat itself in a climb or descent
    double vertical_m_s_ = 0.0;             ///< rate of climb that the robot was told when the last reading came
    Pose leapt_to_;                         ///< the last pose that was not believed
    int leaps_ = 0;                         ///< how often in a row it was told
    bool lean_leapt_ = false;
};

/// Judges the ranges of one scanner. Owned by one robot.
class ScanCheck {
public:
    /// Returns the ranges that can be believed, with NaN for the others; nothing if the geometry in the line differs
    /// from that of the last lines. A single beam that stands out from its neighbors is believed if the last scan had
    /// something like it there, as of a thin mast; otherwise its number may be damaged.
    std::vector<double> believed(const protocol::RangeScan& scan);

private:
    bool isOtherGeometry(const protocol::RangeScan& scan);

    std::vector<double> last_m_; ///< ranges of the last scan as they were told
    double fov_rad_ = 0.0;       ///< 0 before the first scan
    double resolution_rad_ = 0.0;
    int others_ = 0; ///< scans in a row with another geometry
};

/// Judges the ranges of all sonars. Owned by one robot.
class SonarCheck {
public:
    /// Begins a tick: the readings that follow come at this time. `high`: the robot is so high that no sonar hears the
    /// ground.
    void begin(Seconds now, bool high);
    /// Returns the range to believe. Call it for each new reading. A range that jumps is believed when it is told
    /// again; until then the last one holds. One that is much nearer is also believed if the one before it was much
    /// nearer, too, or if another sonar hears something as near in this tick. Returns nothing while the sonar hangs: it
    /// repeats an echo to the last digit although the robot moves. `echo`: the range is less than the greatest one.
    std::optional<double> believed_m(const std::string& sonar, double range_m, bool echo, const Told& told);
    /// True if the last reading was not believed, but is so near that something thin may be there, such as the tip of a
    /// tree, which only one ray has met. Where that happens often, the link damages numbers, and it means nothing.
    bool glimpsed() const { return glimpsed_; }
    void forget() { ranges_.clear(); }

private:
    struct Range {
        double believed_m = 0.0;
        double told_m = 0.0;
        int repeats = 0; ///< of an echo, in a row
    };
    /// Judges a reading and notes what is much nearer than before.
    bool believes(const Range& range, double told_m);
    void noteGlimpse(double told_m);

    std::map<std::string, Range, std::less<>> ranges_;
    std::vector<double> nearer_m_; ///< the ranges of this tick that are much nearer than those before them
    Seconds now_{0.0};
    bool high_ = false;
    std::deque<Seconds> glimpses_; ///< times of the last ones
    bool glimpsed_ = false;
};

} // namespace usar::airrobot
