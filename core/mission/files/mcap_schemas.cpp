#include "core/mission/files/mcap_schemas.h"

#include <initializer_list>
#include <string>
#include <utility>

namespace usar::mission::schemas {

namespace {

using Properties = std::initializer_list<std::pair<std::string, std::string>>;

const std::string number = R"({"type":"number"})";
const std::string text = R"({"type":"string"})";
const std::string flag = R"({"type":"boolean"})";
const std::string whole = R"({"type":"integer","minimum":0})";
const std::string bytes = R"({"type":"string","contentEncoding":"base64"})";

std::string quoted(const std::string& word) {
    return '"' + word + '"';
}

std::string arrayOf(const std::string& items) {
    return R"({"type":"array","items":)" + items + "}";
}

/// `needed` are required, `others` may be absent.
std::string object(const std::string& title, Properties needed, Properties others = {}) {
    std::string properties, required;
    for (const Properties& part : {needed, others})
        for (const auto& [name, type] : part)
            properties += (properties.empty() ? "" : ",") + quoted(name) + ":" + type;
    for (const auto& property : needed)
        required += (required.empty() ? "" : ",") + quoted(property.first);
    return R"({"title":)" + quoted(title) + R"(,"type":"object","properties":{)" + properties + R"(},"required":[)" +
           required + "]}";
}

/// `names` are those of the numbers 0, 1, 2 and so on.
std::string oneOf(const std::string& title, std::initializer_list<std::string> names) {
    std::string values;
    int value = 0;
    for (const std::string& name : names) {
        values +=
            (value > 0 ? "," : "") + (R"({"title":)" + quoted(name)) + R"(,"const":)" + std::to_string(value) + "}";
        ++value;
    }
    return R"({"title":)" + quoted(title) + R"(,"oneOf":[)" + values + "]}";
}

const std::string& time() {
    static const std::string type =
        R"({"type":"object","title":"time","properties":{"sec":{"type":"integer","minimum":0},)"
        R"("nsec":{"type":"integer","minimum":0,"maximum":999999999}},"required":["sec","nsec"]})";
    return type;
}

std::string vector3() {
    return object("foxglove.Vector3", {{"x", number}, {"y", number}, {"z", number}});
}

std::string quaternion() {
    return object("foxglove.Quaternion", {{"x", number}, {"y", number}, {"z", number}, {"w", number}});
}

std::string pose() {
    return object("foxglove.Pose", {{"position", vector3()}, {"orientation", quaternion()}});
}

std::string packedField() {
    const std::string type = oneOf("foxglove.NumericType", {"UNKNOWN", "UINT8", "INT8", "UINT16", "INT16", "UINT32",
                                                            "INT32", "FLOAT32", "FLOAT64"});
    return object("foxglove.PackedElementField", {{"name", text}, {"offset", whole}, {"type", type}});
}

} // namespace

const McapSchema& poseInFrame() {
    static const std::string json =
        object("foxglove.PoseInFrame", {{"timestamp", time()}, {"frame_id", text}, {"pose", pose()}});
    static const McapSchema schema{"foxglove.PoseInFrame", json};
    return schema;
}

const McapSchema& posesInFrame() {
    static const std::string json =
        object("foxglove.PosesInFrame", {{"timestamp", time()}, {"frame_id", text}, {"poses", arrayOf(pose())}});
    static const McapSchema schema{"foxglove.PosesInFrame", json};
    return schema;
}

const McapSchema& frameTransform() {
    static const std::string json = object("foxglove.FrameTransform", {{"timestamp", time()},
                                                                       {"parent_frame_id", text},
                                                                       {"child_frame_id", text},
                                                                       {"translation", vector3()},
                                                                       {"rotation", quaternion()}});
    static const McapSchema schema{"foxglove.FrameTransform", json};
    return schema;
}

const McapSchema& laserScan() {
    static const std::string json = object("foxglove.LaserScan", {{"timestamp", time()},
                                                                  {"frame_id", text},
                                                                  {"pose", pose()},
                                                                  {"start_angle", number},
                                                                  {"end_angle", number},
                                                                  {"ranges", arrayOf(number)},
                                                                  {"intensities", arrayOf(number)}});
    static const McapSchema schema{"foxglove.LaserScan", json};
    return schema;
}

const McapSchema& rawImage() {
    static const std::string json = object("foxglove.RawImage", {{"timestamp", time()},
                                                                 {"frame_id", text},
                                                                 {"width", whole},
                                                                 {"height", whole},
                                                                 {"encoding", text},
                                                                 {"step", whole},
                                                                 {"data", bytes}});
    static const McapSchema schema{"foxglove.RawImage", json};
    return schema;
}

const McapSchema& grid() {
    static const std::string json =
        object("foxglove.Grid", {{"timestamp", time()},
                                 {"frame_id", text},
                                 {"pose", pose()},
                                 {"column_count", whole},
                                 {"cell_size", object("foxglove.Vector2", {{"x", number}, {"y", number}})},
                                 {"row_stride", whole},
                                 {"cell_stride", whole},
                                 {"fields", arrayOf(packedField())},
                                 {"data", bytes}});
    static const McapSchema schema{"foxglove.Grid", json};
    return schema;
}

const McapSchema& log() {
    static const std::string level =
        oneOf("foxglove.LogLevel", {"UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"});
    static const std::string json = object(
        "foxglove.Log",
        {{"timestamp", time()}, {"level", level}, {"message", text}, {"name", text}, {"file", text}, {"line", whole}});
    static const McapSchema schema{"foxglove.Log", json};
    return schema;
}

const McapSchema& range() {
    static const std::string json =
        object("usar.Range", {{"timestamp", time()}, {"frame_id", text}, {"range_m", number}});
    static const McapSchema schema{"usar.Range", json};
    return schema;
}

const McapSchema& command() {
    static const std::string json =
        object("usar.Command", {{"timestamp", time()}, {"text", text}, {"source", text}, {"trigger_line", whole}});
    static const McapSchema schema{"usar.Command", json};
    return schema;
}

const McapSchema& status() {
    static const std::string json = object("usar.Status",
                                           {{"timestamp", time()},
                                            {"state", text},
                                            {"elapsed_s", number},
                                            {"distance_flown_m", number},
                                            {"charges", whole},
                                            {"paused", flag}},
                                           {{"distance_to_goal_m", number},
                                            {"battery_used_pct", number},
                                            {"range_left_m", number},
                                            {"progress_pct", number},
                                            {"time_left_s", number}});
    static const McapSchema schema{"usar.Status", json};
    return schema;
}

const McapSchema& plan() {
    static const std::string json =
        object("usar.Plan", {{"timestamp", time()}, {"plan", text}, {"cycle", whole}, {"active", arrayOf(text)}});
    static const McapSchema schema{"usar.Plan", json};
    return schema;
}

} // namespace usar::mission::schemas
