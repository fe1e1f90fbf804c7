// Spells messages in JSON by the schemas of an exported recording, and gives each topic its channel.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/mapping/raster_export.h"
#include "core/mission/files/json_pen.h"
#include "core/mission/files/mcap_schemas.h"
#include "core/mission/runs/export_clock.h"

namespace usar::mission {

/// Levels of foxglove.Log.
enum class LogLevel : std::uint8_t { Debug = 1, Info = 2, Warning = 3, Error = 4 };

/// A text for the log, in UTF-8; bytes that are not are replaced.
struct LogEntry {
    LogLevel level = LogLevel::Info;
    std::string_view text;
    std::string_view by;    ///< who says it
    std::uint64_t line = 0; ///< info line that it is about; 0: none
};

/// Writes into a writer that must outlive it, as must the clock. A message with a pose that is not finite is left out,
/// and so are those of further topics once there are `most_topics`, because sensors' names come from the wire.
class TopicWriter {
public:
    static constexpr std::size_t most_topics = 512;

    TopicWriter(McapWriter& file, const ExportClock& clock) : file_(file), clock_(clock) {}

    /// `own`: the time that the message tells itself (ExportClock::timesOf). `fill` appends what the schema has besides
    /// the timestamp, each part with a comma before it.
    void send(const std::string& topic, const McapSchema& schema, std::optional<Seconds> own,
              const std::function<void(JsonPen&)>& fill);

    void pose(const std::string& topic, const std::string& frame, const Pose& pose, std::optional<Seconds> own);
    void transform(const std::string& topic, const std::string& parent, const std::string& child,
                   const Pose& child_in_parent, std::optional<Seconds> own);
    void log(const LogEntry& entry);
    /// Heights with row 0 at the lowest y. A raster of more than `most_grid_cells` is made coarser: cells become the
    /// mean of those that are known.
    void grid(const std::string& topic, const mapping::Raster& raster);

    static constexpr std::size_t most_grid_cells = std::size_t(1) << 20;

    /// Messages that were left out.
    std::uint64_t leftOut() const { return left_out_; }

private:
    McapWriter& file_;
    const ExportClock& clock_;
    std::map<std::string, McapChannel> channels_; ///< by topic
    std::string json_;                            ///< of the message that is being written
    std::uint64_t left_out_ = 0;
};

/// The name in the form that topics and frames have: letters, digits, underscores, hyphens and periods; others become
/// underscores. At most 64 characters; "unnamed" for none.
std::string topicPart(std::string_view name);

// Parts of messages.
void writeFrame(JsonPen& pen, std::string_view frame);            ///< `,"frame_id":…`
void writePose(JsonPen& pen, const Pose& pose);                   ///< an object: position and orientation
void writeRanges(JsonPen& pen, std::span<const double> ranges_m); ///< an array; -1 for what is not finite
void writeFloats(JsonPen& pen, std::span<const float> values);    ///< base64 of little-endian floats, with quotes
/// UTF-8 in quotes; bytes that are none are replaced.
void writeText(JsonPen& pen, std::string_view text);

} // namespace usar::mission
