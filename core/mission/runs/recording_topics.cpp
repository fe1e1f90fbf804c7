#include "core/mission/runs/recording_topics.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "core/agent/published_text.h"
#include "core/base/alternatives.h"
#include "core/base/text.h"
#include "core/mission/files/flown_mission.h"
#include "core/protocol/fields.h"

namespace usar::mission {

namespace {

/// At least this long lies between two height maps.
constexpr Seconds map_interval{10.0};
/// A depth image with more pixels is damaged.
constexpr double most_pixels = 4e6;
constexpr std::size_t most_cameras = 16;

// How well a sensor's pose stands for what the robot itself believes.
constexpr int by_truth = 1;
constexpr int by_ins = 2;

void optionalNumber(JsonPen& pen, std::string_view name, const std::optional<double>& value) {
    if (!value || !std::isfinite(*value))
        return;
    pen.raw(",");
    pen.key(name);
    pen.number(*value);
}

/// A number that the schema demands: 0 if it is none.
void requiredNumber(JsonPen& pen, std::string_view name, double value) {
    optionalNumber(pen, name, std::isfinite(value) ? value : 0.0);
}

LogLevel levelOf(Severity severity) {
    return severity == Severity::Note      ? LogLevel::Info
           : severity == Severity::Warning ? LogLevel::Warning
                                           : LogLevel::Error;
}

} // namespace

RecordingTopics::RecordingTopics(McapWriter& file, std::string_view robot_name, double cell_size_m, Seconds begin)
    : file_(file)
    , robot_(topicPart(robot_name))
    , clock_(begin)
    , topics_(file, clock_)
    , plan_([this](const ActiveParts& parts) { takePlan(parts); })
    , mapper_(cell_size_m) {}

void RecordingTopics::beginConnection(std::string_view place) {
    clock_.beginConnection();
    mapper_.forgetScans();
    strips_.clear();
    topics_.log({.text = "connected to " + std::string(place), .by = "session"});
}

void RecordingTopics::endConnection(std::string_view reason) {
    const std::string lost = "the connection was lost: " + std::string(reason);
    if (reason.empty())
        topics_.log({.text = "the connection was closed", .by = "session"});
    else
        topics_.log({.level = LogLevel::Warning, .text = lost, .by = "session"});
}

void RecordingTopics::take(const protocol::InfoLine& line) {
    if (const auto time = protocol::timeOf(line.message))
        clock_.take(*time);
    for (const Diagnostic& diagnostic : line.diagnostics)
        topics_.log({levelOf(diagnostic.severity), diagnostic.message, "protocol", line.number.value});
    if (const auto* const scan = std::get_if<protocol::RangeScan>(&line.message))
        mapper_.takeScan(*scan, line.number);
    else if (const auto* const configuration = std::get_if<protocol::ConfigurationInfo>(&line.message))
        mapper_.takeConfiguration(*configuration);
    read(line.message);
}

void RecordingTopics::read(const protocol::InfoMessage& message) {
    const auto& variant = static_cast<const protocol::InfoVariant&>(message);
    std::visit(Overloaded{[this](const protocol::RangeScan& scan) { take(scan); },
                          [this](const protocol::GeometryInfo& geometry) { take(geometry); },
                          [this](const protocol::RangeImage& strip) { take(strip); },
                          [this](const protocol::SonarReadings& sonars) { take(sonars.ranges, sonars.time); },
                          [this](const protocol::RangeReadings& rays) { take(rays.ranges, rays.time); },
                          [this](const protocol::InsReading& ins) {
                              takeSensorPose(ins.name, ins.base_in_map, ins.time, by_ins);
                          },
                          [this](const protocol::GroundTruthReading& truth) {
                              takeSensorPose(truth.name, truth.base_in_map, truth.time, by_truth);
                          },
                          [this](const protocol::OdometryReading& odometry) {
                              if (odometry.base_in_start)
                                  topics_.pose(topic("pose", odometry.name), frame("start"), *odometry.base_in_start,
                                               odometry.time);
                          },
                          [](const auto&) {}},
               variant);
}

void RecordingTopics::take(const protocol::GeometryInfo& geometry) {
    for (const protocol::MountedItem& item : geometry.items) {
        const auto known = mounts_.find(item.name);
        if (known != mounts_.end() && known->second == item.item_in_mount)
            continue; // A robot may ask again and again.
        mounts_[item.name] = item.item_in_mount;
        const std::string mount = sameWord(item.mount, "HARD") ? "base" : item.mount;
        topics_.transform(topic("mount", item.name), frame(mount), frame(item.name), item.item_in_mount, std::nullopt);
    }
}

void RecordingTopics::take(const protocol::RangeScan& scan) {
    if (scan.ranges_m.empty() || !std::isfinite(scan.fov_rad) || !std::isfinite(scan.step_rad()))
        return;
    topics_.send(topic("scan", scan.name), schemas::laserScan(), scan.time, [&](JsonPen& pen) {
        writeFrame(pen, frame(scan.name));
        pen.raw(",\"pose\":");
        writePose(pen, {});
        pen.raw(",\"start_angle\":");
        pen.number(scan.beamAngle_rad(0));
        pen.raw(",\"end_angle\":");
        pen.number(scan.beamAngle_rad(scan.ranges_m.size() - 1));
        pen.raw(",\"ranges\":");
        writeRanges(pen, scan.ranges_m);
        pen.raw(",\"intensities\":[]");
    });
}

void RecordingTopics::take(const protocol::RangeImage& strip) {
    const bool sensible = strip.size_px.size() == 2 && strip.size_px[0] >= 1.0 && strip.size_px[1] >= 1.0 &&
                          strip.size_px[0] * strip.size_px[1] <= most_pixels;
    if (!sensible || (strips_.size() >= most_cameras && !strips_.contains(strip.name)))
        return;
    Strips& image = strips_[strip.name];
    const auto columns = static_cast<std::size_t>(strip.size_px[0]);
    const auto rows = static_cast<std::size_t>(strip.size_px[1]);
    if (strip.frame.value_or(0) == 0 || columns != image.columns || rows != image.rows)
        image = {columns, rows, {}};
    image.depths_m.insert(image.depths_m.end(), strip.depths_m.begin(), strip.depths_m.end());
    const bool complete = image.depths_m.size() == columns * rows;
    if (complete)
        topics_.send(topic("image", strip.name), schemas::rawImage(), strip.time, [&](JsonPen& pen) {
            writeFrame(pen, frame(strip.name));
            pen.raw(",\"width\":");
            pen.number(std::uint64_t(columns));
            pen.raw(",\"height\":");
            pen.number(std::uint64_t(rows));
            pen.raw(",\"encoding\":\"32FC1\",\"step\":");
            pen.number(std::uint64_t(columns * sizeof(float)));
            pen.raw(",\"data\":");
            writeFloats(pen, image.depths_m);
        });
    if (complete || image.depths_m.size() > columns * rows)
        strips_.erase(strip.name);
}

void RecordingTopics::take(const std::vector<protocol::NamedRange>& ranges, std::optional<Seconds> time) {
    for (const protocol::NamedRange& range : ranges)
        if (std::isfinite(range.range_m))
            topics_.send(topic("range", range.name), schemas::range(), time, [&](JsonPen& pen) {
                writeFrame(pen, frame(range.name));
                pen.raw(",\"range_m\":");
                pen.number(range.range_m);
            });
}

void RecordingTopics::takeSensorPose(const std::string& sensor, const Pose& base_in_map, std::optional<Seconds> time,
                                     int rank) {
    topics_.pose(topic("pose", sensor), "map", base_in_map, time);
    sensor_rank_ = std::max(sensor_rank_, rank);
    if (!behavior_tells_ && rank == sensor_rank_)
        moveBase(base_in_map, time);
}

void RecordingTopics::moveBase(const Pose& base_in_map, std::optional<Seconds> time) {
    topics_.pose(topic("pose"), "map", base_in_map, time);
    topics_.transform(topic("transform"), "map", frame("base"), base_in_map, time);
}

void RecordingTopics::takeSent(const link::Record& record) {
    const std::string_view text = trimmed(record.bytes);
    topics_.send(topic("command"), schemas::command(), std::nullopt, [&](JsonPen& pen) {
        pen.raw(",\"text\":");
        pen.text(text);
        pen.raw(",\"source\":");
        writeText(pen, record.name);
        pen.raw(",\"trigger_line\":");
        pen.number(record.trigger.value);
    });
}

void RecordingTopics::takeNote(const link::Record& record) {
    if (record.name == "mission") {
        takeMission(record.bytes);
    } else if (record.name == "fault") {
        topics_.log({LogLevel::Warning, record.bytes, "simulator"});
    } else if (record.name == "behavior") {
        behavior_tells_ = false;
        topics_.log({.text = "started", .by = record.bytes.substr(0, record.bytes.find('\t'))});
    } else if (record.name == "finished") {
        behavior_tells_ = false;
        const bool success = record.bytes.starts_with('1');
        topics_.log(
            {success ? LogLevel::Info : LogLevel::Error, record.bytes.substr(record.bytes.find(' ') + 1), "behavior"});
    } else if (record.name == "published") {
        if (const auto value = agent::readPublished(record.bytes))
            take(*value);
    }
}

/// The size of the cells may have been chosen after the recording began.
void RecordingTopics::takeMission(std::string_view text) {
    if (const auto flown = readFlownMission(text, {}); flown && mapper_.map().knownCellCount() == 0)
        mapper_.clearMap(flown->mission.cell_size_m);
}

void RecordingTopics::take(const agent::Published& value) {
    std::visit(
        Overloaded{[this](const agent::BehaviorStatus& status) { take(status); },
                   [this](const agent::PoseEstimate& estimate) {
                       behavior_tells_ = true;
                       moveBase(estimate.base_in_map, estimate.time);
                   },
                   [this](const agent::ScanPlacement& placement) { take(placement); },
                   [this](const agent::PlannedPath& path) { take(path); },
                   [this](const agent::PlanTrace& trace) { plan_.take(trace.bytes); },
                   [this](const agent::BehaviorEvent& event) {
                       topics_.log({levelOf(event.severity), event.text, "behavior"});
                   },
                   [this](const agent::BehaviorFinished& finished) {
                       behavior_tells_ = false;
                       topics_.log({finished.success ? LogLevel::Info : LogLevel::Error, finished.reason, "behavior"});
                   },
                   [this](const agent::PlanHalted& halted) {
                       const std::string text = "halted " + halted.reason;
                       topics_.log({.text = text, .by = "plan"});
                   },
                   [this](const agent::PlanResumed&) { topics_.log({.text = "goes on", .by = "plan"}); },
                   [](const auto&) {}},
        static_cast<const agent::PublishedVariant&>(value));
}

void RecordingTopics::take(const agent::BehaviorStatus& status) {
    topics_.send(topic("status"), schemas::status(), status.time, [&](JsonPen& pen) {
        pen.raw(",\"state\":");
        writeText(pen, status.state);
        requiredNumber(pen, "elapsed_s", status.elapsed.count());
        requiredNumber(pen, "distance_flown_m", status.distance_flown_m);
        pen.raw(",\"charges\":");
        pen.number(static_cast<std::uint64_t>(std::max(0, status.charges)));
        pen.raw(status.paused ? ",\"paused\":true" : ",\"paused\":false");
        optionalNumber(pen, "distance_to_goal_m", status.distance_to_goal_m);
        optionalNumber(pen, "battery_used_pct", status.battery_used_pct);
        optionalNumber(pen, "range_left_m", status.range_left_m);
        optionalNumber(pen, "progress_pct", status.progress_pct);
        if (status.time_left)
            optionalNumber(pen, "time_left_s", status.time_left->count());
    });
}

void RecordingTopics::take(const agent::PlannedPath& path) {
    topics_.send(topic("path"), schemas::posesInFrame(), std::nullopt, [&](JsonPen& pen) {
        writeFrame(pen, "map");
        pen.raw(",\"poses\":[");
        bool first = true;
        for (const Vec2& point_in_map_m : path.points_in_map_m) {
            if (!point_in_map_m.allFinite())
                continue;
            pen.next(first);
            writePose(pen, {.position_m = {point_in_map_m.x(), point_in_map_m.y(), 0.0}});
        }
        pen.raw("]");
    });
}

void RecordingTopics::take(const agent::ScanPlacement& placement) {
    if (!mapper_.place(placement))
        return;
    map_changed_ = true;
    growMap();
}

void RecordingTopics::takePlan(const ActiveParts& parts) {
    topics_.send(topic("plan"), schemas::plan(), std::nullopt, [&](JsonPen& pen) {
        pen.raw(",\"plan\":");
        writeText(pen, parts.plan);
        pen.raw(",\"cycle\":");
        pen.number(parts.cycle);
        pen.raw(",\"active\":[");
        bool first = true;
        for (const std::string& path : parts.paths) {
            pen.next(first);
            writeText(pen, path);
        }
        pen.raw("]");
    });
}

/// Waits until the rest of the file has grown by as much as the last map took, so that maps are no more than half of
/// it, however large they become.
void RecordingTopics::growMap() {
    const bool is_time = !map_written_ || clock_.now() - *map_written_ >= map_interval;
    if (is_time && file_.size() - file_bytes_at_map_ >= map_bytes_)
        writeMap();
}

void RecordingTopics::writeMap() {
    const mapping::Raster raster = mapping::rasterOf(mapper_.map());
    if (raster.empty() || !std::exchange(map_changed_, false))
        return;
    const std::uint64_t before = file_.size();
    topics_.grid(topic("map"), raster);
    map_written_ = clock_.now();
    file_bytes_at_map_ = file_.size();
    map_bytes_ = file_bytes_at_map_ - before;
}

void RecordingTopics::finish(std::string_view complaint) {
    writeMap();
    if (!complaint.empty())
        topics_.log({LogLevel::Warning, complaint, "recording"});
}

} // namespace usar::mission
