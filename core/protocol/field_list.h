// Collects the values of one message as a flat list.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/fields.h"

namespace usar::protocol {

/// `source` and `item` hold for what is added after they are set. Numbers that are none are "nan".
class FieldList {
public:
    std::string source;
    std::string item;

    void text(std::string_view field, std::string_view value);
    void number(std::string_view field, double value, std::string_view unit = {});
    template <class Number>
    void number(std::string_view field, const std::optional<Number>& value, std::string_view unit = {}) {
        if (value)
            number(field, static_cast<double>(*value), unit);
    }
    void flag(std::string_view field, const std::optional<bool>& value);
    /// x, y, z of it, or roll, pitch, yaw; "field.x", or "x" without a field.
    void vector(std::string_view field, const Vec3& value, std::string_view unit, bool is_angles = false);
    void pose(const Pose& pose);
    /// Each one; of long lists count, minimum, mean and maximum.
    void values(std::string_view field, std::span<const double> values, std::string_view unit);
    void summary(std::string_view field, std::span<const double> values, std::string_view unit);
    void add(Field field) { fields_.push_back(std::move(field)); }

    std::vector<Field> take() { return std::move(fields_); }

    /// Longer lists are summed up.
    static constexpr std::size_t longest_list = 16;

private:
    static std::string partOf(std::string_view field, std::string_view part);

    std::vector<Field> fields_;
};

} // namespace usar::protocol
