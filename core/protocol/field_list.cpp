#include "core/protocol/field_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace usar::protocol {

std::string FieldList::partOf(std::string_view field, std::string_view part) {
    std::string name(field);
    if (!field.empty())
        name += '.';
    return name.append(part);
}

void FieldList::put(const FieldView& field) {
    fields_.push_back({std::string(field.source), std::string(field.item), std::string(field.field), field.number,
                       std::string(field.text), std::string(field.unit)});
}

void FieldList::text(std::string_view field, std::string_view value) {
    put({source, item, field, std::nullopt, value, {}});
}

void FieldList::number(std::string_view field, double value, std::string_view unit) {
    if (std::isfinite(value))
        put({source, item, field, value, {}, unit});
    else
        put({source, item, field, std::nullopt, "nan", unit});
}

void FieldList::flag(std::string_view field, const std::optional<bool>& value) {
    if (value)
        text(field, *value ? "True" : "False");
}

void FieldList::vector(std::string_view field, const Vec3& value, std::string_view unit, bool is_angles) {
    static constexpr std::array axes = {"x", "y", "z"};
    static constexpr std::array angles = {"roll", "pitch", "yaw"};
    for (std::size_t i = 0; i < 3; ++i)
        number(partOf(field, is_angles ? angles[i] : axes[i]), value[static_cast<Eigen::Index>(i)], unit);
}

void FieldList::pose(const Pose& pose) {
    vector("", pose.position_m, "m");
    vector("", {pose.roll_rad, pose.pitch_rad, pose.yaw_rad}, "rad", true);
}

void FieldList::values(std::string_view field, std::span<const double> values, std::string_view unit) {
    if (putList(field, values, unit))
        return;
    if (values.size() > longest_list)
        return summary(field, values, unit);
    for (std::size_t i = 0; i < values.size(); ++i)
        number(partOf(field, std::to_string(i)), values[i], unit);
}

void FieldList::summary(std::string_view field, std::span<const double> values, std::string_view unit) {
    if (putList(field, values, unit))
        return;
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    double sum = 0.0;
    double count = 0.0;
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
        sum += value;
        ++count;
    }
    number(partOf(field, "count"), static_cast<double>(values.size()));
    number(partOf(field, "minimum"), minimum, unit);
    number(partOf(field, "mean"), sum / count, unit);
    number(partOf(field, "maximum"), maximum, unit);
}

} // namespace usar::protocol
