// SEN messages of scanners that cover an area: RangeScanner3D and RangeImager.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// A scan by a scanner that turns about two axes. `resolution_rad` and `fov_rad` hold the vertical and then the
/// horizontal value; ranges are in row-major order. No recording of this sensor is known, so the order within a row is
/// kept as on the wire (protocol.md 4.5).
/// On the wire: `SEN {Time 1} {Type RangeScanner3D} {Name S} {Resolution 0.5,0.25} {FOV 1,0.5} {Range 1,2,3}`.
struct Scan3d {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<double> resolution_rad{};
    std::vector<double> fov_rad{};
    std::vector<double> ranges_m{};
    std::string type = "RangeScanner3D"; ///< value of Type on the wire

    static constexpr std::string_view wire_types = "RangeScanner3D|3DRangeScanner";
    static constexpr auto items() {
        return std::tuple(item("Resolution", &Scan3d::resolution_rad, "resolution", "rad"),
                          item("FOV", &Scan3d::fov_rad, "fov", "rad"), item("Range", &Scan3d::ranges_m, "range", "m"));
    }
    bool operator==(const Scan3d&) const = default;
};

/// A strip of a depth image (UDK's Kinect). Depths are measured along the optical axis; rows run from top to bottom
/// and, unlike scans, from left to right. The image is sent in `frames` strips; 0 before the first request. UDK prints
/// fractions without their leading zeros, so 2.05 arrives as 2.5, which cannot be corrected here.
/// On the wire: `SEN {Type RangeImager} {Name k} {Resolution 2,1} {FOV 1.5,0.75} {Frames 2} {Frame 0} {Range 1,2}`.
struct RangeImage {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<double> size_px{}; ///< width, height
    std::vector<double> fov_rad{}; ///< horizontal, vertical
    std::optional<long long> frames{};
    std::optional<long long> frame{}; ///< number of this strip
    std::vector<double> depths_m{};

    static constexpr std::string_view wire_types = "RangeImager";
    /// True if the line is a depth image. MOAST uses the same type for a plain scanner, which has a single resolution.
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
