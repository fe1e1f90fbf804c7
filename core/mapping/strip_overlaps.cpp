#include "core/mapping/strip_overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/mapping/hit.h"

namespace usar::mapping {

namespace {

constexpr double flattest_cosine = 0.25; ///< 75 degrees off the vertical
constexpr double look_knots = 2.0;       ///< length of a look
constexpr double apart_knots = 25.0 / KnotTimes::spacing.count();
constexpr float most_difference_m = 3.0f;
/// A smaller slope may as well be noise of the heights or of the attitude.
constexpr float least_slope = 0.08f;
/// A larger slope is that of a crown or a wall, which is not the same within a cell.
constexpr float steep_slope = 2.0f;
constexpr double reach_m = 25.0;
/// Farther from the middle of the path than this, a position is garbled.
constexpr double far_m = 5000.0;

struct Look {
    std::uint32_t cell = 0;
    float height_m = 0.0f;
    Eigen::Vector2f middle_m = Eigen::Vector2f::Zero(); ///< of its hits, from the corner of the cell
    Eigen::Vector2f arm_m = Eigen::Vector2f::Zero();    ///< from the scanner to its hits, level
    bool even = true;
    double moment = 0.0;
};

/// Sums up the hits of the present look at one cell. Heights and moments are relative to the first one, so that they do
/// not lose digits.
struct CellSums {
    int look = -1;
    std::uint32_t hits = 0;
    float first_m = 0.0f, sum_m = 0.0f, sum_m2 = 0.0f, x_m = 0.0f, y_m = 0.0f, moments = 0.0f;
    float arm_x_m = 0.0f, arm_y_m = 0.0f;
    double first_moment = 0.0;

    Look finished(std::uint32_t cell, float uneven_m) const {
        const auto n = static_cast<float>(hits);
        const float mean_m = sum_m / n;
        const float variance_m2 = std::max(0.0f, sum_m2 / n - mean_m * mean_m);
        return {cell,
                first_m + mean_m,
                Eigen::Vector2f(x_m, y_m) / n,
                Eigen::Vector2f(arm_x_m, arm_y_m) / n,
                variance_m2 < uneven_m * uneven_m,
                first_moment + double(moments / n)};
    }
};

/// A square grid over a rectangle, with sums of heights from which slopes are made.
class LookGrid {
public:
    LookGrid(const Rectangle& extent, double cell_size_m)
        : cell_m_(cell_size_m)
        , cells_per_m_(1.0 / cell_size_m)
        , low_m_(extent.min_m - Vec2::Constant(reach_m))
        , columns_(static_cast<std::int64_t>(std::ceil((extent.width_m() + 2.0 * reach_m) / cell_size_m)) + 1)
        , rows_(static_cast<std::int64_t>(std::ceil((extent.height_m() + 2.0 * reach_m) / cell_size_m)) + 1) {}

    bool tooLarge() const { return columns_ * rows_ > static_cast<std::int64_t>(StripHits::most_cells); }
    /// To be called before anything else. Of `hits`, some are of one look; memory that nobody touches costs nothing.
    void allocate(std::size_t hits) {
        cells_.resize(static_cast<std::size_t>(columns_ * rows_));
        looks_.reserve(hits / 2);
    }

    /// `arm_m` is from the scanner to the hit, level.
    void add(const Vec3& scanner_m, const Eigen::Vector2f& arm_m, float z_m, double moment) {
        const double column = (scanner_m.x() - low_m_.x() + double(arm_m.x())) * cells_per_m_;
        const double row = (scanner_m.y() - low_m_.y() + double(arm_m.y())) * cells_per_m_;
        if (!(column >= 0.0 && row >= 0.0 && column < double(columns_) && row < double(rows_)))
            return;
        const auto at =
            static_cast<std::size_t>(static_cast<std::int64_t>(row) * columns_ + static_cast<std::int64_t>(column));
        CellSums& sums = cells_[at];
        const int look = static_cast<int>(moment / look_knots);
        if (sums.look != look) {
            finish(at);
            sums = {.look = look, .first_m = z_m, .first_moment = moment};
        }
        const float above_m = z_m - sums.first_m;
        ++sums.hits;
        sums.sum_m += above_m;
        sums.sum_m2 += above_m * above_m;
        sums.arm_x_m += arm_m.x();
        sums.arm_y_m += arm_m.y();
        sums.x_m += static_cast<float>((column - std::floor(column)) * cell_m_);
        sums.y_m += static_cast<float>((row - std::floor(row)) * cell_m_);
        sums.moments += static_cast<float>(moment - sums.first_moment);
    }

    /// Ends all looks and returns the pairs of those at one cell.
    std::vector<Overlap> pairs() {
        for (std::size_t at = 0; at < cells_.size(); ++at)
            finish(at);
        sortByCell();
        makeSlopes();
        std::vector<Overlap> found;
        found.reserve(looks_.size());
        for (std::size_t i = 0; i < looks_.size(); ++i)
            for (const std::size_t further : {1, 3}) {
                const std::size_t j = i + further;
                if (j >= looks_.size() || looks_[j].cell != looks_[i].cell)
                    break;
                addPair(looks_[i], looks_[j], found);
            }
        return found;
    }

private:
    float uneven_m() const { return cell_m_ > 1.0 ? 1.2f : 0.6f; }

    void finish(std::size_t at) {
        const CellSums& sums = cells_[at];
        if (sums.hits >= (cell_m_ < 0.6 ? 1u : 2u))
            looks_.push_back(sums.finished(static_cast<std::uint32_t>(at), uneven_m()));
    }

    /// Looks at one cell stay in order of time.
    void sortByCell() {
        std::vector<std::uint32_t> starts(cells_.size() + 1, 0);
        for (const Look& look : looks_)
            ++starts[look.cell + 1];
        for (std::size_t at = 1; at < starts.size(); ++at)
            starts[at] += starts[at - 1];
        std::vector<Look> sorted(looks_.size());
        for (const Look& look : looks_)
            sorted[starts[look.cell]++] = look;
        looks_ = std::move(sorted);
    }

    /// Smooths the mean heights with the weights of a bell of one cell and takes central differences.
    void makeSlopes() {
        std::vector<float> sums(cells_.size(), 0.0f), weights(cells_.size(), 0.0f);
        for (const Look& look : looks_) {
            sums[look.cell] += look.height_m - looks_.front().height_m;
            weights[look.cell] += 1.0f;
        }
        for (std::vector<float>* const values : {&sums, &weights}) {
            smooth(*values, 1);
            smooth(*values, columns_);
        }
        heights_m_ = std::move(sums);
        for (std::size_t at = 0; at < heights_m_.size(); ++at)
            heights_m_[at] =
                weights[at] > 1e-3f ? heights_m_[at] / weights[at] : std::numeric_limits<float>::quiet_NaN();
    }

    static void smooth(std::vector<float>& values, std::int64_t stride) {
        static constexpr std::array<float, 4> bell{0.39905f, 0.24204f, 0.05401f, 0.00443f};
        const auto size = static_cast<std::int64_t>(values.size());
        std::vector<float> out(values.size(), 0.0f);
        for (std::int64_t at = 0; at < size; ++at) {
            float sum = bell[0] * values[static_cast<std::size_t>(at)];
            for (std::int64_t k = 1; k < 4; ++k) {
                const std::int64_t before = at - k * stride, after = at + k * stride;
                sum +=
                    bell[static_cast<std::size_t>(k)] * ((before >= 0 ? values[static_cast<std::size_t>(before)] : 0) +
                                                         (after < size ? values[static_cast<std::size_t>(after)] : 0));
            }
            out[static_cast<std::size_t>(at)] = sum;
        }
        values = std::move(out);
    }

    float slopeAlong(std::size_t cell, std::int64_t stride) const {
        const auto at = static_cast<std::int64_t>(cell);
        if (at < stride || at + stride >= static_cast<std::int64_t>(heights_m_.size()))
            return 0.0f;
        const float slope =
            (heights_m_[static_cast<std::size_t>(at + stride)] - heights_m_[static_cast<std::size_t>(at - stride)]) /
            static_cast<float>(2.0 * cell_m_);
        return std::isfinite(slope) ? slope : 0.0f;
    }

    /// The two looks have hit different places in the cell, which is no difference of the looks.
    void addPair(const Look& early, const Look& late, std::vector<Overlap>& found) const {
        if (!early.even || !late.even || late.moment - early.moment < apart_knots)
            return;
        Eigen::Vector2f slope(slopeAlong(early.cell, 1), slopeAlong(early.cell, columns_));
        for (float& along : slope)
            along = std::abs(along) < least_slope ? 0.0f : along;
        float difference_m = early.height_m - late.height_m;
        if (slope.norm() < steep_slope)
            difference_m -= slope.dot(early.middle_m - late.middle_m);
        if (std::abs(difference_m) < most_difference_m)
            found.push_back({early.moment, late.moment, difference_m, slope, early.arm_m, late.arm_m});
    }

    double cell_m_;
    double cells_per_m_;
    Vec2 low_m_;
    std::int64_t columns_;
    std::int64_t rows_;
    std::vector<CellSums> cells_;
    std::vector<Look> looks_;
    std::vector<float> heights_m_;
};

/// The positions that are not too far from the median one on both axes.
Rectangle extentOf(std::span<const KeptScan* const> scans) {
    std::vector<double> sorted(scans.size());
    Vec2 median_m = Vec2::Zero();
    for (int axis = 0; axis < 2 && !scans.empty(); ++axis) {
        std::ranges::transform(scans, sorted.begin(),
                               [&](const KeptScan* scan) { return scan->scanner_in_map.position_m[axis]; });
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::ranges::nth_element(sorted, middle);
        median_m[axis] = *middle;
    }
    Rectangle extent{median_m, median_m};
    for (const KeptScan* scan : scans) {
        const Vec2 at_m = scan->scanner_in_map.position_m.head<2>();
        if ((at_m - median_m).cwiseAbs().maxCoeff() > far_m)
            continue;
        extent.min_m = extent.min_m.cwiseMin(at_m);
        extent.max_m = extent.max_m.cwiseMax(at_m);
    }
    return extent;
}

} // namespace

KnotTimes::KnotTimes(const std::vector<Sortie>& sorties) {
    for (const Sortie& sortie : sorties) {
        begins_.push_back(sortie.begin);
        first_.push_back(count_);
        const auto knots = static_cast<std::size_t>((sortie.end - sortie.begin) / spacing) + 2;
        count_ += knots + knots % 2; // An even number, so that no look spans two sorties.
    }
    first_.push_back(count_);
}

double KnotTimes::moment(std::size_t sortie, Seconds time) const {
    return static_cast<double>(first_[sortie]) + (time - begins_[sortie]) / spacing;
}

Seconds KnotTimes::time(std::size_t sortie, std::size_t knot) const {
    return begins_[sortie] + static_cast<double>(knot - first_[sortie]) * spacing;
}

StripHits::StripHits(std::span<const KeptScan* const> scans, const KnotTimes& knots) : extent_(extentOf(scans)) {
    std::vector<Eigen::Vector2f> rays;
    const KeptScan* of_rays = nullptr;
    for (const KeptScan* scan : scans) {
        if (!of_rays || scan->resolution_rad != of_rays->resolution_rad || scan->fov_rad != of_rays->fov_rad ||
            scan->ranges_m.size() != of_rays->ranges_m.size()) {
            of_rays = scan;
            rays.clear();
            for (std::size_t k = 0; k < scan->ranges_m.size(); ++k) {
                const double angle_rad = -scan->fov_rad / 2.0 + double(k) * scan->resolution_rad;
                rays.emplace_back(std::cos(angle_rad), std::sin(angle_rad));
            }
        }
        origins_.push_back({scan->scanner_in_map.position_m, knots.moment(scan->sortie, scan->time), hits_m_.size()});
        const Eigen::Matrix3f turn = scan->scanner_in_map.rotation().toRotationMatrix().cast<float>();
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const float range_m = scan->ranges_m[k];
            const Eigen::Vector3f ray = turn.leftCols<2>() * rays[k];
            if (range_m > 0.0f && isHit(double(range_m), scan->maximum_m) && ray.z() < -flattest_cosine)
                hits_m_.emplace_back(range_m * ray);
        }
    }
    if (!origins_.empty())
        origins_.push_back({Vec3::Zero(), 0.0, hits_m_.size()});
}

double StripHits::finest_m() const {
    double cell_size_m = 0.5;
    while (LookGrid(extent_, cell_size_m).tooLarge())
        cell_size_m *= 2.0;
    return cell_size_m;
}

std::vector<Overlap> StripHits::overlaps(double cell_size_m, const KnotErrors& errors) const {
    LookGrid grid(extent_, cell_size_m);
    if (empty() || grid.tooLarge()) // Whoever asks for cells finer than the finest finds nothing.
        return {};
    grid.allocate(hits_m_.size());
    const std::size_t scans_apart = cell_size_m > 1.5 ? 3 : cell_size_m > 0.75 ? 2 : 1;
    for (std::size_t i = 0; i + 1 < origins_.size(); i += scans_apart) {
        const Origin& origin = origins_[i];
        const auto knot = static_cast<std::size_t>(origin.moment);
        const double part = origin.moment - double(knot);
        const KnotError error = (1.0 - part) * errors[knot] + part * errors[knot + 1];
        const Vec3 from_m = origin.position_m - error.head<3>();
        const auto cosine = static_cast<float>(std::cos(error.w())), sine = static_cast<float>(std::sin(error.w()));
        const auto from_z_m = static_cast<float>(from_m.z());
        for (std::size_t hit = origin.first_hit; hit < origins_[i + 1].first_hit; ++hit) {
            const Eigen::Vector3f& hit_m = hits_m_[hit];
            const Eigen::Vector2f arm_m(cosine * hit_m.x() + sine * hit_m.y(), cosine * hit_m.y() - sine * hit_m.x());
            grid.add(from_m, arm_m, from_z_m + hit_m.z(), origin.moment);
        }
    }
    return grid.pairs();
}

} // namespace usar::mapping
