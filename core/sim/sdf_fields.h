// Numbers, poses and attributes out of SDF elements, and where an element stands in its file. For the world readers.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <ignition/math/Pose3.hh>
#include <sdf/Element.hh>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace usar::sim {

/// `what` on the element's line: libsdformat knows those of SDFormat's own elements; those of ours are sought in the
/// file by the element's place among its parent's.
tl::unexpected<Error> refusal(const std::string& what, const std::filesystem::path& file, const sdf::Element& element);

Pose toPose(const ignition::math::Pose3d& pose);
Vec3 toVec3(const ignition::math::Vector3d& vector);

/// Attribute of an element of ours; nothing when it is missing or empty.
std::optional<std::string> attributeOf(const sdf::Element& element, const std::string& name);
/// A finite number; nothing when it is missing or anything else.
std::optional<double> numberOf(const sdf::Element& element, const std::string& attribute);
/// Text of a child element of ours.
std::optional<std::string> childText(sdf::Element& element, const std::string& name);

/// Fills `values` with as many finite numbers with blanks between them; false where there is anything else.
bool readNumbers(std::string_view text, double* values, std::size_t count);

/// The text of an element as `count` finite numbers.
template <std::size_t count>
std::optional<std::array<double, count>> numbersIn(const sdf::Element& element) {
    std::array<double, count> values{};
    const auto value = element.GetValue();
    return value && readNumbers(value->GetAsString(), values.data(), count) ? std::optional(values) : std::nullopt;
}

} // namespace usar::sim
