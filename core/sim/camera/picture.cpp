#include "core/sim/camera/picture.h"

#include <algorithm>

namespace usar::sim {

void paste(Picture& whole, const Picture& part, int x, int y) {
    for (int row = 0; row < part.height_px; ++row)
        std::copy_n(part.at(0, row), 3 * part.width_px, whole.at(x, y + row));
}

Picture cut(const Picture& whole, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height) {
    const auto left = static_cast<int>(std::clamp<std::int64_t>(x, 0, whole.width_px - 1));
    const auto top = static_cast<int>(std::clamp<std::int64_t>(y, 0, whole.height_px - 1));
    Picture part(static_cast<int>(std::clamp<std::int64_t>(width, 1, whole.width_px - left)),
                 static_cast<int>(std::clamp<std::int64_t>(height, 1, whole.height_px - top)));
    for (int row = 0; row < part.height_px; ++row)
        std::copy_n(whole.at(left, top + row), 3 * part.width_px, part.at(0, row));
    return part;
}

} // namespace usar::sim
