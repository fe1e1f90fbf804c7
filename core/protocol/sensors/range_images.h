// SEN of scanners that see an area: RangeScanner3D, RangeImager.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// A scanner that turns about two axes. `resolution_rad` and `fov_rad` are vertical and horizontal; ranges come row
/// after row. No capture of it is known, so the order within a row is the wire's (usarsim-protocol 4.5).
struct Scan3d {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<double> resolution_rad{};
    std::vector<double> fov_rad{};
    std::vector<double> ranges_m{};
    std::string type = "RangeScanner3D"; ///< on the wire

    static constexpr std::string_view wire_types = "RangeScanner3D|3DRangeScanner";
    static constexpr auto items() {
        return std::tuple(item("Resolution", &Scan3d::resolution_rad, "resolution", "rad"),
                          item("FOV", &Scan3d::fov_rad, "fov", "rad"), item("Range", &Scan3d::ranges_m, "range", "m"));
    }
    bool operator==(const Scan3d&) const = default;
};

/// A strip of a depth image (UDK's Kinect). Depths lie along the optical axis, rows top to bottom and, unlike scans,
/// left to right. The image comes in `frames` strips; 0 while nothing was asked for. UDK prints a fraction without its
/// leading zeros, so 2.05 arrives as 2.5; nothing can mend that here.
struct RangeImage {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<double> size_px{}; ///< width, height
    std::vector<double> fov_rad{}; ///< horizontal, vertical
    std::optional<long long> frames{};
    std::optional<long long> frame{};
    std::vector<double> depths_m{};

    static constexpr std::string_view wire_types = "RangeImager";
    /// MOAST calls a plain scanner by the same name; that one has a single resolution.
    static bool fits(const Segments& segments) { return segments.value("Resolution").find(',') != std::string::npos; }
    static constexpr auto items() {
        return std::tuple(item("Resolution", &RangeImage::size_px, "size", "px"),
                          item("FOV", &RangeImage::fov_rad, "fov", "rad"),
                          item("Frames", &RangeImage::frames, "frames"), item("Frame", &RangeImage::frame, "frame"),
                          item("Range", &RangeImage::depths_m, "depth", "m"));
    }
    bool operator==(const RangeImage&) const = default;
};

} // namespace usar::protocol
