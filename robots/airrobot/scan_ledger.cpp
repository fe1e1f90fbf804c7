#include "robots/airrobot/scan_ledger.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace usar::airrobot {

namespace {

/// A beam that misses looks for ground only if it is no flatter than 30 degrees; flatter ones end above it.
constexpr double least_down = 0.5;
/// It has looked for ground if it ends so far below what the robot flies over: from high up, beams end in the air above
/// a street.
constexpr double below_ground_m = 4.0;
/// A larger area is not watched cell by cell. This is 100 square kilometers.
constexpr double most_cells = 1e8;

constexpr std::uint8_t all_quarters = 0b1111;
constexpr std::uint8_t bottomless_bit = 0b10000;

/// The bit of the quarter of a cell in which a place is, given its offset in cells.
std::uint8_t quarterBit(const Vec2& offset) {
    const int right = offset.x() - std::floor(offset.x()) < 0.5 ? 0 : 1;
    const int upper = offset.y() - std::floor(offset.y()) < 0.5 ? 0 : 1;
    return static_cast<std::uint8_t>(1 << (right + 2 * upper));
}

ScanLedger::Cell cellOfBits(std::uint8_t bits) {
    return bits & all_quarters     ? ScanLedger::Cell::Seen
           : bits & bottomless_bit ? ScanLedger::Cell::Bottomless
                                   : ScanLedger::Cell::Unknown;
}

} // namespace

ScanLedger::ScanLedger(const Rectangle& area_in_map) : area_in_map_(area_in_map) {
    const double columns = std::ceil(area_in_map.width_m() / cell_m);
    const double rows = std::ceil(area_in_map.height_m() / cell_m);
    if (columns * rows > most_cells)
        return;
    columns_ = static_cast<int>(columns);
    rows_ = static_cast<int>(rows);
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

void ScanLedger::note(const Senses& senses, bool on_lane, bool for_map) {
    if (on_lane && senses.now > last_tick_) {
        ++lane_ticks_;
        mapped_ticks_ += for_map && senses.ground_m ? 1 : 0; // Over a void, scans show only what is beside the robot.
        last_tick_ = senses.now;
    }
    if (!for_map || !senses.scan)
        return;
    const Vec3 from_m = senses.scan->scanner_in_map.position_m;
    for (const Vec3& end_m : senses.scan->misses_in_map_m) {
        const Vec3 beam_m = end_m - from_m;
        const bool ends_above_ground = senses.ground_m && end_m.z() > *senses.ground_m - below_ground_m;
        if (-beam_m.z() < least_down * beam_m.norm() || ends_above_ground)
            continue;
        for (double along_m = 0.0; along_m <= beam_m.head<2>().norm(); along_m += cell_m)
            mark(from_m.head<2>() + along_m * beam_m.head<2>().normalized(), bottomless_bit);
    }
    for (const Vec3& hit_m : senses.scan->hits_in_map_m)
        mark(hit_m.head<2>(), quarterBit((hit_m.head<2>() - area_in_map_.min_m) / cell_m));
}

std::optional<std::size_t> ScanLedger::cellAt(const Vec2& at_m) const {
    const Vec2 offset_m = (at_m - area_in_map_.min_m) / cell_m;
    const int column = static_cast<int>(std::floor(offset_m.x()));
    const int row = static_cast<int>(std::floor(offset_m.y()));
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_)
        return std::nullopt;
    return indexOf(column, row);
}

void ScanLedger::mark(const Vec2& at_m, std::uint8_t bits) {
    if (const auto index = cellAt(at_m))
        cells_[*index] |= bits;
}

ScanLedger::Cell ScanLedger::at(int column, int row) const {
    return cellOfBits(cells_[indexOf(column, row)]);
}

double ScanLedger::hidden(int column, int row) const {
    const std::uint8_t bits = cells_[indexOf(column, row)];
    return 1.0 - std::popcount<unsigned>(bits & all_quarters) / 4.0;
}

bool ScanLedger::isSeen(const Vec2& at_m) const {
    const auto index = cellAt(at_m);
    return index && cellOfBits(cells_[*index]) == Cell::Seen;
}

bool ScanLedger::isVoid(int column, int row) const {
    const bool inside = column >= 0 && row >= 0 && column < columns_ && row < rows_;
    return inside && at(column, row) == Cell::Bottomless;
}

double ScanLedger::hiddenInSeen() const {
    long long cells = 0;
    double hidden_cells = 0.0;
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const bool beside_void = isVoid(column - 1, row) || isVoid(column + 1, row) || isVoid(column, row - 1) ||
                                     isVoid(column, row + 1);
            if (at(column, row) != Cell::Seen || beside_void)
                continue;
            ++cells;
            hidden_cells += hidden(column, row);
        }
    return cells == 0 ? 0.0 : hidden_cells / static_cast<double>(cells);
}

ScanLedger::Hidden ScanLedger::hiddenIn(const Rectangle& part_in_map) const {
    Hidden sum;
    const auto cell = [](double from_m, double to_m, int cells) {
        return std::clamp(static_cast<int>(std::lround((to_m - from_m) / cell_m)), 0, cells);
    };
    const int first_row = cell(area_in_map_.min_m.y(), part_in_map.min_m.y(), rows_);
    const int last_row = cell(area_in_map_.min_m.y(), part_in_map.max_m.y(), rows_);
    const int first_column = cell(area_in_map_.min_m.x(), part_in_map.min_m.x(), columns_);
    const int last_column = cell(area_in_map_.min_m.x(), part_in_map.max_m.x(), columns_);
    for (int row = first_row; row < last_row; ++row)
        for (int column = first_column; column < last_column; ++column) {
            if (at(column, row) == Cell::Bottomless) {
                sum.bottomless_m2 += cell_m * cell_m;
                continue;
            }
            sum.area_m2 += cell_m * cell_m;
            sum.hidden_m2 += cell_m * cell_m * hidden(column, row);
        }
    return sum;
}

double ScanLedger::mapped() const {
    return lane_ticks_ == 0 ? 1.0 : static_cast<double>(mapped_ticks_) / static_cast<double>(lane_ticks_);
}

double ScanLedger::share(Cell what) const {
    const auto count = std::ranges::count(cells_, what, cellOfBits);
    return cells_.empty() ? 1.0 : static_cast<double>(count) / static_cast<double>(cells_.size());
}

} // namespace usar::airrobot
