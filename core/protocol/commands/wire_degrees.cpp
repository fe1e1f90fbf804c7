#include "core/protocol/commands/wire_degrees.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace usar::protocol {

namespace {

using Wide = long double;
constexpr Wide radians_per_degree = std::numbers::pi_v<Wide> / 180;

/// The shortest text of a number, kept on the stack.
struct ShortText {
    template <class Number>
    explicit ShortText(Number number) {
        const auto [end, problem] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
        size = problem == std::errc{} ? static_cast<std::size_t>(end - buffer.data()) : 0;
    }
    std::string_view view() const { return {buffer.data(), size}; }

    std::array<char, 64> buffer{};
    std::size_t size = 0;
};

} // namespace

void appendDegrees(std::string& out, double angle_rad) {
    const Wide degrees = angle_rad / radians_per_degree;
    const ShortText plain(static_cast<double>(degrees));
    if (radiansOfDegrees(plain.view()) == angle_rad)
        out.append(plain.view());
    else
        out.append(ShortText(degrees).view());
}

double radiansOfDegrees(std::string_view number) {
    if (number.starts_with('+')) // from_chars does not accept a plus sign
        number.remove_prefix(1);
    Wide degrees = 0;
    std::from_chars(number.data(), number.data() + number.size(), degrees);
    const auto angle_rad = static_cast<double>(degrees * radians_per_degree);
    return std::isfinite(angle_rad) ? angle_rad : 0.0;
}

} // namespace usar::protocol
