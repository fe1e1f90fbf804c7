#include "robots/airrobot/cross_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace usar::airrobot {

namespace {

/// So far to each side, a lane shows what crowns hide from lanes that are farther away, but less at its border.
constexpr int side_cells = 7;
constexpr int step_cells = 2; ///< distance between lines
/// The way to a lane costs about as much as a lane of this length, and one that shows less than this is left out.
constexpr double usual_way_m = 12.0;
constexpr double least_m2 = 12.0;
/// In a small area, ways are shorter, and less is a substantial part: lanes are held to these shares of its cells and
/// of the mean of its sides, and what they must show for their way shrinks with the area below this size.
constexpr double small_area_share = 0.01;
constexpr double usual_way_share = 0.5;
constexpr double small_area_m2 = 5900.0;
constexpr double rounding_m2 = 1e-9;
constexpr double least_lane_m = 5.0; ///< If less is left of the length of all lanes, no more are added.
/// A coarser map may well miss cells of a meter that nothing hides.
constexpr double coarsest_m = 0.75;

/// Where nothing was seen in a square of this half width, there is no shadow: the robot did not get there.
constexpr int shadow_cells = 10;

double weight(int aside_cells) {
    return 1.0 - static_cast<double>(std::abs(aside_cells)) / (side_cells + 1);
}

/// A grid of cells with a mark each, row by row.
struct Marks {
    int columns = 0;
    int rows = 0;
    std::vector<bool> marked;

    /// Marks also what is within `shadow_cells` of a marked cell, along the rows if `step` is 1.
    void widen(int lines, int length, int stride, int step) {
        std::vector<bool> wide(marked.size());
        for (int line = 0; line < lines; ++line) {
            int last = -2 * shadow_cells; // the last marked cell that was passed
            for (int i = 0; i < length + shadow_cells; ++i) {
                if (i < length && marked[std::size_t(line * stride + i * step)])
                    last = i;
                if (const int middle = i - shadow_cells; middle >= 0 && last >= middle - shadow_cells)
                    wide[std::size_t(line * stride + middle * step)] = true;
            }
        }
        marked = std::move(wide);
    }
    /// The same in both directions: a square around each.
    void widen() {
        widen(rows, columns, columns, 1);
        widen(columns, rows, 1, columns);
    }
};

/// The cells that are in a square of which nothing was seen (the morphological opening of what was not).
std::vector<bool> notVisited(const ScanLedger& ledger) {
    Marks marks{ledger.columns(), ledger.rows(), {}};
    for (int row = 0; row < marks.rows; ++row)
        for (int column = 0; column < marks.columns; ++column)
            marks.marked.push_back(ledger.at(column, row) == ScanLedger::Cell::Seen);
    marks.widen();
    marks.marked.flip();
    marks.widen();
    return marks.marked;
}

/// A piece of a line, in cells along it: [from, to).
struct Piece {
    int from = 0;
    int to = 0;
    double worth_m2 = 0.0; ///< gain less the cost of its length, and of the way to it where that is known
    double shown_m2 = 0.0; ///< gain
};

/// The hidden cells of an area, and what each line along one of the axes would show of them.
class HiddenCells {
public:
    explicit HiddenCells(const ScanLedger& ledger, double least_gain_m)
        : size_{ledger.columns(), ledger.rows()}
        , least_m2_(
              std::min(least_m2, small_area_share * size_[0] * size_[1] * ScanLedger::cell_m * ScanLedger::cell_m))
        , least_gain_m_(least_gain_m)
        , hidden_(std::size_t(size_[0]) * std::size_t(size_[1])) {
        for (int axis : {0, 1}) {
            lines_[axis].resize(std::size_t((size_[1 - axis] + step_cells - 1) / step_cells));
            for (Line& line : lines_[axis])
                line.gain_m2.resize(std::size_t(size_[axis]));
        }
        const std::vector<bool> not_visited = notVisited(ledger);
        for (int row = 0; row < size_[1]; ++row)
            for (int column = 0; column < size_[0]; ++column)
                if (!not_visited[indexOf(column, row)])
                    set(column, row, ledger.hidden(column, row));
    }

    struct Found {
        int axis = 0; ///< 0: along x
        int across = 0;
        Piece piece;
    };
    /// The piece that is worth most if `way_m(found)` is the way to it; nullopt if none is worth anything.
    template <class Way>
    std::optional<Found> best(Way&& way_m) {
        std::optional<Found> best;
        for (int axis : {0, 1})
            for (int i = 0; i < static_cast<int>(lines_[axis].size()); ++i) {
                Line& line = lines_[axis][std::size_t(i)];
                if (std::exchange(line.changed, false))
                    line.best = bestPiece(line.gain_m2);
                const double least_worth_m2 = best ? best->piece.worth_m2 : 0.0;
                if (line.best.worth_m2 <= least_worth_m2)
                    continue;
                Found found{axis, i * step_cells, line.best};
                found.piece.worth_m2 -= least_gain_m_ * way_m(found);
                if (found.piece.worth_m2 > least_worth_m2)
                    best = found;
            }
        return best;
    }

    /// Takes what a lane shows for seen.
    void fly(const Found& lane) {
        const int first = std::max(0, lane.across - side_cells);
        const int last = std::min(size_[1 - lane.axis] - 1, lane.across + side_cells);
        for (int across = first; across <= last; ++across)
            for (int along = lane.piece.from; along < lane.piece.to; ++along)
                if (lane.axis == 0)
                    set(along, across, 0.0);
                else
                    set(across, along, 0.0);
    }

private:
    struct Line {
        std::vector<double> gain_m2; ///< by cell along it
        Piece best;
        bool changed = true;
    };

    std::size_t indexOf(int column, int row) const {
        return std::size_t(row) * std::size_t(size_[0]) + std::size_t(column);
    }

    void set(int column, int row, double hidden) {
        const std::size_t index = indexOf(column, row);
        const double change = hidden - static_cast<double>(hidden_[index]);
        if (change == 0.0)
            return;
        hidden_[index] = static_cast<float>(hidden);
        changeLines(0, row, column, change);
        changeLines(1, column, row, change);
    }

    void changeLines(int axis, int across, int along, double change) {
        const int first = std::max(0, (across - side_cells + step_cells - 1) / step_cells);
        const int last = std::min(static_cast<int>(lines_[axis].size()) - 1, (across + side_cells) / step_cells);
        for (int i = first; i <= last; ++i) {
            Line& line = lines_[axis][std::size_t(i)];
            line.gain_m2[std::size_t(along)] +=
                change * weight(i * step_cells - across) * ScanLedger::cell_m * ScanLedger::cell_m;
            line.changed = true;
        }
    }

    /// The piece with the greatest sum of gain less cost (Kadane's algorithm).
    Piece bestPiece(const std::vector<double>& gain_m2) const {
        const double cost_m2 = least_gain_m_ * ScanLedger::cell_m;
        Piece best;
        double sum_m2 = 0.0;
        int from = 0;
        for (int i = 0; i < static_cast<int>(gain_m2.size()); ++i) {
            if (sum_m2 <= 0.0) {
                sum_m2 = 0.0;
                from = i;
            }
            sum_m2 += gain_m2[std::size_t(i)] - cost_m2;
            const double shown_m2 = sum_m2 + cost_m2 * (i + 1 - from);
            if (sum_m2 > best.worth_m2 && shown_m2 > least_m2_)
                best = {from, i + 1, sum_m2, shown_m2};
        }
        return best;
    }

    int size_[2];
    double least_m2_;
    double least_gain_m_;
    std::vector<float> hidden_; ///< share of each cell, row by row
    std::vector<Line> lines_[2];
};

/// Chooses the lanes and orders them.
class LaneChoice {
public:
    LaneChoice(const ScanLedger& ledger, const LaneTerms& terms, const Vec2& from_m, const Vec2& home_m)
        : ledger_(ledger)
        , terms_(terms)
        , from_m_(from_m)
        , home_m_(home_m) {}

    std::vector<mapping::Lane> choose() {
        const double side_m = 0.5 * ScanLedger::cell_m * (ledger_.columns() + ledger_.rows());
        addLanes([&](const mapping::Lane&) { return std::min(usual_way_m, usual_way_share * side_m); });
        orderAndDrop();
        if (lanes_.size() > few_lanes)
            return lanes_;
        // A lane that was not worth a way of its own may be worth a short detour between the others.
        addLanes([this](const mapping::Lane& lane) { return detour_m(from_m_, lanes_, home_m_, lane); });
        orderAndDrop();
        return lanes_;
    }

private:
    mapping::Lane laneOf(const HiddenCells::Found& found, int id) const {
        const auto at = [&](int along) {
            return found.axis == 0 ? ledger_.centerOf_m(along, found.across) : ledger_.centerOf_m(found.across, along);
        };
        return {at(found.piece.from), at(found.piece.to - 1), id};
    }

    /// The line of cells that is nearest to a lane along x or y.
    HiddenCells::Found lineOf(const mapping::Lane& lane) const {
        const Vec2 first_m = ledger_.centerOf_m(0, 0);
        const Vec2 low = (lane.start_m.cwiseMin(lane.end_m) - first_m) / ScanLedger::cell_m;
        const Vec2 high = (lane.start_m.cwiseMax(lane.end_m) - first_m) / ScanLedger::cell_m;
        const int axis = high.x() - low.x() < high.y() - low.y() ? 1 : 0;
        const int cells = axis == 0 ? ledger_.columns() : ledger_.rows();
        const auto cell = [](double at) { return static_cast<int>(std::lround(at)); };
        return {axis, cell(low[1 - axis]),
                Piece{std::clamp(cell(low[axis]), 0, cells), std::clamp(cell(high[axis]) + 1, 0, cells)}};
    }

    /// Adds lanes past what the present ones leave hidden, always the one that is worth most.
    template <class Way>
    void addLanes(Way&& way_m) {
        HiddenCells hidden(ledger_, terms_.least_gain_m);
        for (const mapping::Lane& lane : terms_.flown)
            hidden.fly(lineOf(lane));
        double left_m = terms_.most_m;
        for (const mapping::Lane& lane : lanes_) {
            const HiddenCells::Found& found = found_[static_cast<std::size_t>(lane.quadrant)];
            hidden.fly(found);
            left_m -= (found.piece.to - found.piece.from) * ScanLedger::cell_m;
        }
        const auto way = [&](const HiddenCells::Found& found) { return way_m(laneOf(found, 0)); };
        for (auto found = hidden.best(way); found && left_m > least_lane_m; found = hidden.best(way)) {
            const auto most_cells = static_cast<int>(left_m / ScanLedger::cell_m);
            found->piece.to = std::min(found->piece.to, found->piece.from + most_cells);
            lanes_.push_back(laneOf(*found, static_cast<int>(found_.size())));
            found_.push_back(*found);
            left_m -= (found->piece.to - found->piece.from) * ScanLedger::cell_m;
            hidden.fly(*found);
        }
    }

    /// Orders the lanes, and drops the one that is worth least for as long as the flight to it costs more than it
    /// shows; where there are many, all of those at once. A search for an order from the beginning after each lane
    /// would take longer than a behavior may think.
    void orderAndDrop() {
        orderFlights(from_m_, lanes_, home_m_, terms_.endurance);
        while (dropTheWorthless())
            improveFlights(from_m_, lanes_, home_m_, terms_.endurance);
    }

    /// Returns true if there were any.
    bool dropTheWorthless() {
        const std::size_t before = lanes_.size();
        for (;;) {
            const std::vector<double> worths = worths_m2();
            const double worst_m2 = worths.empty() ? 0.0 : std::ranges::min(worths);
            if (worst_m2 >= 0.0)
                return lanes_.size() < before;
            const double drop_to_m2 = lanes_.size() > few_lanes ? 0.0 : worst_m2 + rounding_m2;
            for (std::size_t i = lanes_.size(); i-- > 0;)
                if (worths[i] < drop_to_m2)
                    lanes_.erase(lanes_.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

    /// Returns the ground that each lane shows, less the ground that the flight to it and along it must be worth.
    std::vector<double> worths_m2() const {
        const double all_m = flight_m(from_m_, lanes_, home_m_, terms_.endurance);
        std::vector<double> worths;
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            std::vector<mapping::Lane> others = lanes_;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            const double saved_m = all_m - flight_m(from_m_, others, home_m_, terms_.endurance);
            worths.push_back(found_[static_cast<std::size_t>(lanes_[i].quadrant)].piece.shown_m2 -
                             terms_.least_gain_m * saved_m);
        }
        return worths;
    }

    const ScanLedger& ledger_;
    LaneTerms terms_;
    Vec2 from_m_;
    Vec2 home_m_;
    std::vector<mapping::Lane> lanes_; ///< their quadrants are indices into `found_`
    std::vector<HiddenCells::Found> found_;
};

} // namespace

std::vector<mapping::Lane> crossLanes(const ScanLedger& ledger, const LaneTerms& terms, const Vec2& from_m,
                                      const Vec2& home_m) {
    if (terms.resolution_m > coarsest_m)
        return {};
    const double area_m2 = ledger.columns() * ledger.rows() * ScanLedger::cell_m * ScanLedger::cell_m;
    LaneTerms held = terms;
    held.least_gain_m *= std::min(1.0, area_m2 / small_area_m2);
    std::vector<mapping::Lane> lanes = LaneChoice(ledger, held, from_m, home_m).choose();
    for (mapping::Lane& lane : lanes)
        lane.quadrant = 0;
    divideIntoSorties(from_m, lanes, home_m, terms.endurance);
    return lanes;
}

} // namespace usar::airrobot
