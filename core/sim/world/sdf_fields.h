// Loads SDFormat files with our kind of error (file, line and reason in one value, nothing on the terminal), and reads
// numbers, poses, shapes and attributes from their elements. Only the readers of worlds and robots include this header,
// so that libsdformat's headers stay out of everyone else's way.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <ignition/math/Pose3.hh>
#include <sdf/Element.hh>
#include <sdf/Geometry.hh>
#include <sdf/Root.hh>

#include "core/base/result.h"
#include "core/sim/world/articulation.h"

namespace usar::sim {

/// What the user can do about a file that cannot be read.
inline constexpr const char* fix_sdf = "Fix the file or generate the world again";

/// Fails for missing files, broken XML and anything that SDFormat does not allow. Callable from several threads, which
/// take turns, because libsdformat has one console per process.
Result<sdf::Root> loadSdf(const std::filesystem::path& file);

/// The error `what` at the element's line. libsdformat knows the lines of SDFormat's own elements; the line of one of
/// ours is found in the file by the element's position among its siblings.
tl::unexpected<Error> refusal(const std::string& what, const std::filesystem::path& file, const sdf::Element& element);

// Both libraries mean meters, radians and the same order of rotations.
Pose toPose(const ignition::math::Pose3d& pose);
Vec3 toVec3(const ignition::math::Vector3d& vector);

/// A solid, and the smallest of its sizes.
struct SizedShape {
    Shape shape;
    double smallest_m = 0.0;
};
/// The geometry as a solid; nullopt unless it is a box, sphere, cylinder or capsule.
std::optional<SizedShape> shapeIn(const sdf::Geometry& geometry);

/// Attribute of one of our elements; nullopt if it is missing or empty.
std::optional<std::string> attributeOf(const sdf::Element& element, const std::string& name);
/// The attribute as a finite number; nullopt if it is missing or anything else.
std::optional<double> numberOf(const sdf::Element& element, const std::string& attribute);
/// Text of the first child with this name; empty if there is none.
std::string textOf(const sdf::Element& parent, const std::string& name);

/// Fills `values` with exactly `count` finite numbers separated by blanks. Returns false if the text is anything else.
bool readNumbers(std::string_view text, double* values, std::size_t count);

/// The element's text as exactly `count` finite numbers; nullopt if it is anything else.
template <std::size_t count>
std::optional<std::array<double, count>> numbersIn(const sdf::Element& element) {
    std::array<double, count> values{};
    const auto value = element.GetValue();
    return value && readNumbers(value->GetAsString(), values.data(), count) ? std::optional(values) : std::nullopt;
}

} // namespace usar::sim
