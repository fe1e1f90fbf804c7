// libsdformat's values to ours. Included by readers of SDFormat only.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <sdf/sdf.hh>

#include "core/base/geometry.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::sim {

inline Vec3 toVec3(const ignition::math::Vector3d& v) {
    return {v.X(), v.Y(), v.Z()};
}

inline Pose toPose(const ignition::math::Pose3d& pose) {
    const ignition::math::Vector3d angles_rad = pose.Rot().Euler();
    return {toVec3(pose.Pos()), angles_rad.X(), angles_rad.Y(), angles_rad.Z()};
}

/// `count` finite numbers with blanks between them, and nothing else.
template <std::size_t count>
std::optional<std::array<double, count>> readList(std::string_view text) {
    std::array<double, count> values{};
    for (double& value : values) {
        const auto number = readNumber(takeWord(text));
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        value = *number;
    }
    return trimmed(text).empty() ? std::optional(values) : std::nullopt;
}

/// What stands between the tags of the first child of this name.
inline std::optional<std::string> textOf(const sdf::Element& parent, const std::string& name) {
    for (sdf::ElementPtr child = parent.GetFirstElement(); child; child = child->GetNextElement())
        if (child->GetName() == name && child->GetValue())
            return child->GetValue()->GetAsString();
    return std::nullopt;
}

inline std::optional<double> numberOf(const sdf::Element& parent, const std::string& name) {
    const auto text = textOf(parent, name);
    return text ? readNumber(*text) : std::nullopt;
}

inline std::string attributeOf(const sdf::Element& element, const std::string& name) {
    const sdf::ParamPtr attribute = element.GetAttribute(name);
    return attribute ? attribute->GetAsString() : std::string();
}

} // namespace usar::sim
