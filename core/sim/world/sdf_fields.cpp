#include "core/sim/world/sdf_fields.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/base/numbers.h"

namespace usar::sim {

namespace {

/// Line of the start tag number `number` (from 0) with this name, not counting comments.
std::optional<int> lineOfTag(const std::filesystem::path& file, const std::string& name, int number) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::string tag = "<" + name;
    int line = 1;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text.compare(at, 4, "<!--") == 0) {
            const std::size_t end = std::min(text.find("-->", at), text.size());
            line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            at = end;
        } else if (text.compare(at, tag.size(), tag) == 0 && number-- == 0) {
            return line;
        } else if (text[at] == '\n') {
            ++line;
        }
    }
    return std::nullopt;
}

std::optional<int> lineOf(const sdf::Element& element, const std::filesystem::path& file) {
    const sdf::ElementPtr parent = element.GetParent();
    if (element.LineNumber() || !parent)
        return element.LineNumber();
    int number = 0;
    for (sdf::ElementPtr other = parent->GetFirstElement(); other && other.get() != &element;
         other = other->GetNextElement())
        number += other->GetName() == element.GetName() ? 1 : 0;
    return lineOfTag(file, element.GetName(), number);
}

} // namespace

tl::unexpected<Error> refusal(const std::string& what, const std::filesystem::path& file, const sdf::Element& element) {
    const auto line = lineOf(element, file);
    return failure(what, line ? file.string() + ":" + std::to_string(*line) : file.string(),
                   "Mend the file or generate the world again");
}

Pose toPose(const ignition::math::Pose3d& pose) {
    const ignition::math::Vector3d angles_rad = pose.Rot().Euler();
    return {toVec3(pose.Pos()), angles_rad.X(), angles_rad.Y(), angles_rad.Z()};
}

Vec3 toVec3(const ignition::math::Vector3d& vector) {
    return {vector.X(), vector.Y(), vector.Z()};
}

std::optional<std::string> attributeOf(const sdf::Element& element, const std::string& name) {
    const auto attribute = element.GetAttribute(name);
    if (!attribute || attribute->GetAsString().empty())
        return std::nullopt;
    return attribute->GetAsString();
}

std::optional<double> numberOf(const sdf::Element& element, const std::string& attribute) {
    const auto text = attributeOf(element, attribute);
    const auto number = text ? readNumber(*text) : std::nullopt;
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::string> childText(sdf::Element& element, const std::string& name) {
    if (!element.HasElement(name))
        return std::nullopt;
    return element.GetElement(name)->Get<std::string>();
}

bool readNumbers(std::string_view text, double* values, std::size_t count) {
    constexpr std::string_view blanks = " \t\r\n";
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) {
        at = text.find_first_not_of(blanks, at);
        if (at == std::string_view::npos)
            return false;
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        const auto number = readNumber(text.substr(at, end - at));
        if (!number || !std::isfinite(*number))
            return false;
        values[i] = *number;
        at = end;
    }
    return text.find_first_not_of(blanks, at) == std::string_view::npos;
}

} // namespace usar::sim
