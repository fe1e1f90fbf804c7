// Turns what a recording holds into the topics of an exported one (resources/docs/headless.md, "Recordings as MCAP").
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/agent/published.h"
#include "core/link/recording_format.h"
#include "core/mission/runs/export_clock.h"
#include "core/mission/runs/recorded_plan.h"
#include "core/mission/runs/topic_writer.h"
#include "core/mission/session/scan_mapper.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Takes lines, commands and notes in the order of the recording. What it keeps grows with the mapped ground and with
/// the number of sensors, but not with the time. The writer must outlive it.
class RecordingTopics {
public:
    /// `begin`: what the protocol clock reads first.
    RecordingTopics(McapWriter& file, std::string_view robot_name, double cell_size_m, Seconds begin);

    void beginConnection(std::string_view place);
    /// `reason`: why the connection was lost; empty: we closed it.
    void endConnection(std::string_view reason);
    void take(const protocol::InfoLine& line);
    void takeSent(const link::Record& record);
    void takeNote(const link::Record& record);
    /// Writes the last height map. `complaint`: what is missing in the recording; empty: nothing.
    void finish(std::string_view complaint);

    /// Messages that were left out because they say nothing sensible, or their topic was one too many.
    std::uint64_t leftOut() const { return topics_.leftOut(); }

private:
    /// Strips of a depth image that is not complete yet.
    struct Strips {
        std::size_t columns = 0;
        std::size_t rows = 0;
        std::vector<float> depths_m;
    };

    void read(const protocol::InfoMessage& message);
    void take(const protocol::GeometryInfo& geometry);
    void take(const protocol::RangeScan& scan);
    void take(const protocol::RangeImage& strip);
    void take(const std::vector<protocol::NamedRange>& ranges, std::optional<Seconds> time);
    void take(const agent::Published& value);
    void take(const agent::BehaviorStatus& status);
    void take(const agent::PlannedPath& path);
    void take(const agent::ScanPlacement& placement);
    void takeMission(std::string_view text);
    void takePlan(const ActiveParts& parts);
    /// Poses that sensors tell are also the robot's as long as nothing better does.
    void takeSensorPose(const std::string& sensor, const Pose& base_in_map, std::optional<Seconds> time, int rank);
    void moveBase(const Pose& base_in_map, std::optional<Seconds> time);
    /// Writes the height map where it is time for it.
    void growMap();
    void writeMap();

    std::string topic(std::string_view what) const { return "/" + robot_ + "/" + std::string(what); }
    std::string topic(std::string_view what, const std::string& of) const { return topic(what) + "/" + topicPart(of); }
    std::string frame(const std::string& of) const { return robot_ + "/" + topicPart(of); }

    McapWriter& file_;
    std::string robot_; ///< as a part of topics and frames
    ExportClock clock_;
    TopicWriter topics_;
    RecordedPlan plan_;
    ScanMapper mapper_;
    std::map<std::string, Strips> strips_; ///< by sensor
    std::map<std::string, Pose> mounts_;   ///< by item, as they were told last
    int sensor_rank_ = 0;                  ///< of the best sensor that has told the robot's pose so far
    bool behavior_tells_ = false;          ///< the robot's pose
    bool map_changed_ = false;
    std::optional<Seconds> map_written_;  ///< when it was written last
    std::uint64_t map_bytes_ = 0;         ///< of that message
    std::uint64_t file_bytes_at_map_ = 0; ///< behind that message
};

} // namespace usar::mission
