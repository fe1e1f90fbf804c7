// Finds where strips of a map overlap, and how much their heights differ there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/mapping/scan_store.h"

namespace usar::mapping {

/// Knots of the error of a path: `spacing` apart from the beginning of each sortie, those of a sortie after those of
/// the one before. A moment is a knot number with a fraction, so that it is between two knots of its sortie.
class KnotTimes {
public:
    static constexpr Seconds spacing{5.0};

    explicit KnotTimes(const std::vector<Sortie>& sorties);
    std::size_t count() const { return count_; }
    /// The first knot of a sortie; with the number of sorties, `count`.
    std::size_t first(std::size_t sortie) const { return first_[sortie]; }
    double moment(std::size_t sortie, Seconds time) const;
    Seconds time(std::size_t sortie, std::size_t knot) const;

private:
    std::vector<Seconds> begins_;
    std::vector<std::size_t> first_; ///< and the count after the last one
    std::size_t count_ = 0;
};

/// Errors by knot: x, y and z of the position, in meters, and the yaw, in rad; map frame, estimate minus truth.
using KnotError = Eigen::Vector4d;
using KnotErrors = std::vector<KnotError>;

/// Two looks at one cell of a map at different times.
struct Overlap {
    double early = 0.0; ///< moments (KnotTimes) of the two looks
    double late = 0.0;
    float difference_m = 0.0f;                       ///< height at the early look minus that at the late one
    Eigen::Vector2f slope = Eigen::Vector2f::Zero(); ///< of the map there
    /// From the scanner to the place, level, map frame, at the two looks.
    Eigen::Vector2f early_arm_m = Eigen::Vector2f::Zero();
    Eigen::Vector2f late_arm_m = Eigen::Vector2f::Zero();
};

/// A number that is the same for overlaps whose looks are from the same two intervals between knots.
inline std::uint64_t intervalsOf(const Overlap& overlap) {
    return (static_cast<std::uint64_t>(overlap.early) << 32) | static_cast<std::uint64_t>(overlap.late);
}

/// The hits of kept scans, relative to the scanner. Beams of up to 75 degrees off the vertical are used, because
/// flatter ones show the sides of things. Built once for an adjustment; 12 bytes a hit. A plain value.
class StripHits {
public:
    StripHits() = default;
    StripHits(std::span<const KeptScan* const> scans, const KnotTimes& knots);

    bool empty() const { return origins_.empty(); }
    /// The rectangle of all scanner positions.
    const Rectangle& extent() const { return extent_; }
    /// Overlaps on a grid of cells of this size, with the path corrected by `errors`. A look at a cell is the
    /// mean of what was hit in it within ten seconds. Looks are left out where the heights in it disagree, as at a
    /// wall, and pairs of looks that are less than 25 s apart or that differ by 3 m and more. `cell_size_m` is
    /// at least `finest_m`.
    std::vector<Overlap> overlaps(double cell_size_m, const KnotErrors& errors) const;

    /// The side of the smallest cells that a grid over all scans can have, for which there is room for `most_cells`:
    /// 0.5 m up to an area of one square kilometer, and twice that for each fourfold area.
    double finest_m() const;
    static constexpr std::size_t most_cells = std::size_t(1) << 22;

private:
    struct Origin {
        Vec3 position_m;
        double moment = 0.0;
        std::size_t first_hit = 0;
    };
    std::vector<Origin> origins_; ///< and one more that only ends the last one's hits
    std::vector<Eigen::Vector3f> hits_m_;
    Rectangle extent_;
};

} // namespace usar::mapping
