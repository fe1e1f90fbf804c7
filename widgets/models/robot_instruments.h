// The instruments of one robot: which it gets, and what they show. Made from what the robot itself says.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/agent/published.h"
#include "core/protocol/sensors/range_scan.h"
#include "widgets/models/fitting.h"
#include "widgets/models/heard.h"
#include "widgets/models/pose_watch.h"
#include "widgets/models/reading_list.h"

namespace usar::widgets {

/// A single figure with its caption, such as the height over ground.
struct InstrumentFigure {
    QString caption; ///< "over ground"; no two figures of a robot have the same
    QString value;   ///< formatted; a dash if there is no number now
    QString unit;
    QString help; ///< what it is and which sensor it comes from
    Heard heard{};
};

/// A sonar as it is mounted, seen from above.
struct SonarCone {
    std::string name;
    Vec2 at_m = Vec2::Zero(); ///< on the robot: x forward, y left
    double bearing_rad = 0.0; ///< counterclockwise from straight ahead
    double half_angle_rad = 0.0;
    double range_m = 0.0; ///< NaN: not heard of lately, or no number
    double maximum_m = 0.0;
    agent::Risk risk = agent::Risk::None; ///< as the behavior judges it
    bool operator==(const SonarCone&) const = default;
};

/// All sonars whose places are known and that look sideways; empty: there is no ring to draw.
struct SonarRing {
    double length_m = 0.0; ///< of the robot; 0 if unknown
    double width_m = 0.0;
    std::vector<SonarCone> cones;
    bool operator==(const SonarRing&) const = default;
};

/// To be fed with every line of one robot. Has an instrument for each thing that the robot has told of, and for nothing
/// else; a sensor without one is still in the list of sensors. A plain value without a clock.
class RobotInstruments {
public:
    /// `now` is the protocol clock after the line. A line without a time of its own counts as sent with the one before.
    void take(const protocol::InfoLine& line, Seconds now);
    /// Height of the water's surface in the map, if the world is known and has one.
    void setWater(std::optional<double> surface_z_m) { water_z_m_ = surface_z_m; }

    /// Counts the lines that changed something.
    std::uint64_t revision() const { return revision_; }
    const Fitting& fitting() const { return fitting_; }
    const PoseWatch& pose() const { return pose_; }
    /// Heights, depth and speeds, as far as the robot's sensors give them.
    std::vector<InstrumentFigure> figures(Seconds now) const;

    /// The newest scan of the first scanner; nullptr without one.
    const protocol::RangeScan* scan() const { return scan_ ? &*scan_ : nullptr; }
    const Heard& scanHeard() const { return scan_heard_; }
    /// As CONF told, else the usual one.
    double scanMaximum_m() const;
    /// True if the scanner looks down: as GEO told, else if the robot flies as far as is known.
    bool scansGround() const;

    /// All sonars in ring order, without risks; empty without sonars. One that has fallen silent while others have not
    /// has no number.
    agent::SonarZones sonars(Seconds now) const;
    const Heard& sonarsHeard() const { return sonars_heard_; }
    /// `zones`: the risks, by the names of the sonars.
    SonarRing ring(const agent::SonarZones& zones) const;

    /// In the order in which their kinds first appeared.
    const std::vector<ReadingList>& lists() const { return lists_; }
    /// True while the robot has told of nothing that an instrument could show.
    bool empty() const;
    /// True once everything that sends regularly must have been heard.
    bool settled(Seconds now) const;

private:
    struct DownRay {
        std::string type;
        double range_m = 0.0;
        Heard heard{};
    };
    void takeSonars(const protocol::SonarReadings& reading, Seconds at);
    void takeRays(const std::string& type, const std::vector<protocol::NamedRange>& ranges, Seconds at);
    void dropRaysThatLookDown();
    void takeLists(const protocol::InfoMessage& message, Seconds at);
    double maximumOf(const std::string& type, const std::string& name, double otherwise_m) const;
    /// Distance to what is below, measured by a scanner or a ray that looks down, upright even if the robot leans.
    std::optional<InstrumentFigure> clearance(Seconds now) const;
    void addHeights(std::vector<InstrumentFigure>& figures, Seconds now) const;
    void addSpeeds(std::vector<InstrumentFigure>& figures, Seconds now) const;

    Fitting fitting_;
    PoseWatch pose_;
    std::optional<protocol::RangeScan> scan_;
    Heard scan_heard_;
    std::map<std::string, std::pair<double, Heard>> sonars_; ///< ranges in meters, by name
    Heard sonars_heard_;
    std::map<std::string, DownRay> down_rays_; ///< by name
    std::optional<protocol::AltitudeReading> altitude_;
    Heard altitude_heard_;
    std::vector<ReadingList> lists_;
    std::optional<double> water_z_m_;
    std::optional<Seconds> clock_; ///< time of the newest line that had one
    std::optional<Seconds> first_heard_;
    std::uint64_t revision_ = 0;
};

} // namespace usar::widgets
