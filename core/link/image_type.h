// How a frame of the image server is packed (usarsim-protocol 6.1).
#pragma once

#include <cstdint>

namespace usar::link {

/// The first byte of a frame. JPEG from best to worst.
enum class ImageType : std::uint8_t { Raw, Superb, Good, Normal, Fair, Bad };
inline constexpr std::uint8_t last_image_type = 5;
/// Type and size of the data (4 bytes, big-endian).
inline constexpr int frame_head_bytes = 5;

} // namespace usar::link
