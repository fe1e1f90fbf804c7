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

/// One value as it is added; the texts are valid during the call only.
struct FieldView {
    std::string_view source, item, field;
    std::optional<double> number;
    std::string_view text, unit;
};

/// Takes the values of messages and builds a list of Fields; a derived class may do something else with each value.
/// `source` and `item` apply to all values added after they are set. A number that is NaN or infinite is added without
/// a number and with the text "nan".
class FieldList {
public:
    FieldList() = default;
    virtual ~FieldList() = default;
    FieldList(const FieldList&) = delete;
    FieldList& operator=(const FieldList&) = delete;

    std::string source;
    std::string item;

    void text(std::string_view field, std::string_view value);
    void number(std::string_view field, double value, std::string_view unit = {});
    /// Adds nothing if the value is absent; neither does `flag`.
    template <class Number>
    void number(std::string_view field, const std::optional<Number>& value, std::string_view unit = {}) {
        if (value)
            number(field, static_cast<double>(*value), unit);
    }
    void flag(std::string_view field, const std::optional<bool>& value);
    /// Adds the components x, y, z, or with `is_angles` roll, pitch, yaw; they are named "field.x", or "x" if `field`
    /// is empty.
    void vector(std::string_view field, const Vec3& value, std::string_view unit, bool is_angles = false);
    /// Adds x, y, z in m and roll, pitch, yaw in rad.
    void pose(const Pose& pose);
    /// Adds each value under its index ("field.0"), or the summary if there are more than `longest_list`.
    void values(std::string_view field, std::span<const double> values, std::string_view unit);
    /// Adds the number of values, and the minimum, mean and maximum of the finite ones, which are "nan" if there are
    /// none.
    void summary(std::string_view field, std::span<const double> values, std::string_view unit);
    void add(const FieldView& field) { put(field); }

    /// Moves the list out.
    std::vector<Field> take() { return std::move(fields_); }

    /// Longer lists are summarized.
    static constexpr std::size_t longest_list = 16;

protected:
    virtual void put(const FieldView& field);
    /// A list of numbers as a whole. True if it has been taken; otherwise its values or its summary are added.
    virtual bool putList(std::string_view /*field*/, std::span<const double> /*values*/, std::string_view /*unit*/) {
        return false;
    }

private:
    /// "field.part", or "part" if `field` is empty.
    static std::string partOf(std::string_view field, std::string_view part);

    std::vector<Field> fields_;
};

} // namespace usar::protocol
