// A picture as plain bytes, and the operations with which the image server combines and crops pictures.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace usar::sim {

/// Rows from the top, three bytes per pixel: red, green, blue. Black when constructed.
struct Picture {
    Picture() = default;
    Picture(int width, int height)
        : width_px(width)
        , height_px(height)
        , rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    /// The three bytes of a pixel, which must be inside the picture.
    std::uint8_t* at(int x, int y) { return rgb.data() + offset(x, y); }
    const std::uint8_t* at(int x, int y) const { return rgb.data() + offset(x, y); }
    std::array<int, 3> pixel(int x, int y) const { return {at(x, y)[0], at(x, y)[1], at(x, y)[2]}; }

    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> rgb;
    bool operator==(const Picture&) const = default;

private:
    std::size_t offset(int x, int y) const {
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x));
    }
};

/// Draws `part` into `whole` with its top left corner at (x, y). It must fit.
void paste(Picture& whole, const Picture& part, int x, int y);
/// Crops `whole`. What lies outside of it is left out, but the result has at least one pixel.
Picture cut(const Picture& whole, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height);

/// `quality` is 1 to 100. The picture must have at least one pixel.
std::string jpegOf(const Picture& picture, int quality);

} // namespace usar::sim
