// What a USARSim server has unless somebody configured it otherwise: the ports of its services, and the ranges of its
// sensors until their CONF tells.
#pragma once

#include <cstdint>

namespace usar::protocol {

/// TCP ports (protocol.md 2.1).
namespace usual_port {
inline constexpr std::uint16_t bot = 3000;
inline constexpr std::uint16_t image = 5003;
inline constexpr std::uint16_t wireless = 50000;
inline constexpr std::uint16_t com_server = 5874;
inline constexpr std::uint16_t com_interface = 7435;
} // namespace usual_port

/// Maximum range of a laser range scanner (SICK LMS and the like), in meters.
inline constexpr double usual_scanner_maximum_m = 20.0;
/// Maximum range of a sonar, in meters.
inline constexpr double usual_sonar_maximum_m = 5.0;
/// Horizontal angle of view of a camera, in radians (80 degrees).
inline constexpr double usual_camera_fov_rad = 1.396;

} // namespace usar::protocol
