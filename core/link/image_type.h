// Packing of an image server's frame (protocol.md 6.1).
#pragma once

#include <cstdint>

namespace usar::link {

/// First byte of a frame: raw pixels, or JPEG from the best to the worst quality.
enum class ImageType : std::uint8_t { Raw, Superb, Good, Normal, Fair, Bad };
inline constexpr std::uint8_t last_image_type = 5;
/// Size of a frame's head in bytes: its type, then the size of the data (4 bytes, big-endian).
inline constexpr int frame_head_bytes = 5;

} // namespace usar::link
