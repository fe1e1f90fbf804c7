#include "core/mission/runs/topic_writer.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/base/text.h"

namespace usar::mission {

namespace {

constexpr std::uint64_t nanoseconds_a_second = 1'000'000'000;

/// An object of numbers.
void writeObject(JsonPen& pen, std::initializer_list<std::pair<std::string_view, double>> fields) {
    pen.raw("{");
    bool first = true;
    for (const auto& [name, value] : fields) {
        pen.next(first);
        pen.key(name);
        pen.number(value);
    }
    pen.raw("}");
}

void writeVector(JsonPen& pen, const Vec3& vector) {
    writeObject(pen, {{"x", vector.x()}, {"y", vector.y()}, {"z", vector.z()}});
}

void writeRotation(JsonPen& pen, const Pose& pose) {
    const Eigen::Quaterniond rotation = pose.rotation();
    writeObject(pen, {{"x", rotation.x()}, {"y", rotation.y()}, {"z", rotation.z()}, {"w", rotation.w()}});
}

void writeTime(JsonPen& pen, std::uint64_t time_ns) {
    pen.raw("{\"sec\":");
    pen.number(time_ns / nanoseconds_a_second);
    pen.raw(",\"nsec\":");
    pen.number(time_ns % nanoseconds_a_second);
    pen.raw("}");
}

bool isFinite(const Pose& pose) {
    return pose.position_m.allFinite() && std::isfinite(pose.roll_rad) && std::isfinite(pose.pitch_rad) &&
           std::isfinite(pose.yaw_rad);
}

/// A raster with row 0 at the lowest y.
struct Grid {
    std::size_t columns = 0;
    std::size_t rows = 0;
    double cell_size_m = 0.0;
    Vec2 corner_in_map_m = Vec2::Zero(); ///< of the first cell
    std::vector<float> heights_m{};
};

/// The mean of the known heights in a block of the raster; NaN without any.
float meanHeight_m(const mapping::Raster& raster, std::int64_t first_column, std::int64_t last_row, std::int64_t side) {
    double sum_m = 0.0;
    int known = 0;
    for (std::int64_t row = std::max<std::int64_t>(0, last_row - side + 1); row <= last_row; ++row)
        for (std::int64_t column = first_column; column < std::min(first_column + side, raster.columns); ++column)
            if (const float height_m = raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)];
                !std::isnan(height_m)) {
                sum_m += double(height_m);
                ++known;
            }
    return known > 0 ? static_cast<float>(sum_m / known) : std::numeric_limits<float>::quiet_NaN();
}

Grid gridOf(const mapping::Raster& raster, std::size_t most_cells) {
    std::int64_t side = 1; // Cells of the raster along a cell of the grid.
    const auto count = [&](std::int64_t cells) { return static_cast<std::size_t>((cells + side - 1) / side); };
    while (count(raster.columns) * count(raster.rows) > most_cells)
        ++side;
    Grid grid{
        .columns = count(raster.columns), .rows = count(raster.rows), .cell_size_m = raster.cell_size_m * double(side)};
    grid.corner_in_map_m = raster.upper_left_center_m - Vec2(0.5, double(raster.rows) - 0.5) * raster.cell_size_m;
    grid.heights_m.reserve(grid.columns * grid.rows);
    for (std::size_t row = 0; row < grid.rows; ++row)
        for (std::size_t column = 0; column < grid.columns; ++column)
            grid.heights_m.push_back(meanHeight_m(raster, static_cast<std::int64_t>(column) * side,
                                                  raster.rows - 1 - static_cast<std::int64_t>(row) * side, side));
    return grid;
}

} // namespace

std::string topicPart(std::string_view name) {
    constexpr std::size_t longest = 64;
    std::string part(name.substr(0, longest));
    std::ranges::replace_if(
        part, [](char c) { return !isWordByte(c) && c != '-' && c != '.'; }, '_');
    return part.empty() ? "unnamed" : part;
}

void writeFrame(JsonPen& pen, std::string_view frame) {
    pen.raw(",\"frame_id\":");
    pen.utf8(frame);
}

void writePose(JsonPen& pen, const Pose& pose) {
    pen.raw("{\"position\":");
    writeVector(pen, pose.position_m);
    pen.raw(",\"orientation\":");
    writeRotation(pen, pose);
    pen.raw("}");
}

void writeRanges(JsonPen& pen, std::span<const double> ranges_m) {
    constexpr double no_range_m = -1.0; // JSON has no NaN, and readers drop what is below the least range.
    pen.raw("[");
    bool first = true;
    for (const double range_m : ranges_m) {
        pen.next(first);
        pen.number(std::isfinite(range_m) ? range_m : no_range_m);
    }
    pen.raw("]");
}

void writeFloats(JsonPen& pen, std::span<const float> values) {
    mapping::ByteBuffer bytes;
    bytes.reserve(values.size_bytes());
    for (const float value : values)
        bytes.add(value);
    const QByteArray text =
        QByteArray::fromRawData(bytes.bytes().data(), static_cast<qsizetype>(bytes.size())).toBase64();
    pen.raw("\"");
    pen.raw({text.constData(), static_cast<std::size_t>(text.size())});
    pen.raw("\"");
}

void writeText(JsonPen& pen, std::string_view text) {
    pen.utf8(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).toStdString());
}

void TopicWriter::send(const std::string& topic, const McapSchema& schema, std::optional<Seconds> own,
                       const std::function<void(JsonPen&)>& fill) {
    auto channel = channels_.find(topic);
    if (channel == channels_.end()) {
        if (channels_.size() >= most_topics) {
            ++left_out_;
            return;
        }
        channel = channels_.emplace(topic, file_.addChannel(topic, schema)).first;
    }
    const McapTimes times = clock_.timesOf(own);
    json_.clear();
    JsonPen pen(json_);
    pen.raw("{\"timestamp\":");
    writeTime(pen, times.published_ns);
    fill(pen);
    pen.raw("}");
    file_.write(channel->second, times, json_);
}

void TopicWriter::pose(const std::string& topic, const std::string& frame, const Pose& pose,
                       std::optional<Seconds> own) {
    if (!isFinite(pose)) {
        ++left_out_;
        return;
    }
    send(topic, schemas::poseInFrame(), own, [&](JsonPen& pen) {
        writeFrame(pen, frame);
        pen.raw(",\"pose\":");
        writePose(pen, pose);
    });
}

void TopicWriter::transform(const std::string& topic, const std::string& parent, const std::string& child,
                            const Pose& child_in_parent, std::optional<Seconds> own) {
    if (!isFinite(child_in_parent)) {
        ++left_out_;
        return;
    }
    send(topic, schemas::frameTransform(), own, [&](JsonPen& pen) {
        pen.raw(",\"parent_frame_id\":");
        pen.utf8(parent);
        pen.raw(",\"child_frame_id\":");
        pen.utf8(child);
        pen.raw(",\"translation\":");
        writeVector(pen, child_in_parent.position_m);
        pen.raw(",\"rotation\":");
        writeRotation(pen, child_in_parent);
    });
}

void TopicWriter::log(const LogEntry& entry) {
    send("/log", schemas::log(), std::nullopt, [&](JsonPen& pen) {
        pen.raw(",\"level\":");
        pen.number(static_cast<std::uint64_t>(entry.level));
        pen.raw(",\"message\":");
        writeText(pen, entry.text);
        pen.raw(",\"name\":");
        writeText(pen, entry.by);
        pen.raw(",\"file\":\"\",\"line\":");
        pen.number(entry.line);
    });
}

void TopicWriter::grid(const std::string& topic, const mapping::Raster& raster) {
    const Grid grid = gridOf(raster, most_grid_cells);
    send(topic, schemas::grid(), std::nullopt, [&](JsonPen& pen) {
        writeFrame(pen, "map");
        pen.raw(",\"pose\":");
        writePose(pen, {.position_m = {grid.corner_in_map_m.x(), grid.corner_in_map_m.y(), 0.0}});
        pen.raw(",\"column_count\":");
        pen.number(std::uint64_t(grid.columns));
        pen.raw(",\"cell_size\":");
        writeObject(pen, {{"x", grid.cell_size_m}, {"y", grid.cell_size_m}});
        pen.raw(",\"row_stride\":");
        pen.number(std::uint64_t(grid.columns * sizeof(float)));
        pen.raw(",\"cell_stride\":4,\"fields\":[{\"name\":\"elevation\",\"offset\":0,\"type\":7}],\"data\":");
        writeFloats(pen, grid.heights_m);
    });
}

} // namespace usar::mission
