#include "robots/airrobot/cross_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "robots/airrobot/lane_order.h"

namespace usar::airrobot {

namespace {

/// So far to each side, a lane shows what crowns hide from lanes that are farther away, but less at its border.
constexpr int side_cells = 7;
constexpr int step_cells = 2; ///< distance between lines
/// The way to a lane costs about as much as a lane of this length, and one that shows less than this is left out.
constexpr double way_m = 12.0;
constexpr double least_m2 = 12.0;
constexpr double least_lane_m = 5.0; ///< If less is left of the length of all lanes, no more are added.
/// A coarser map may well miss cells of a meter that nothing hides.
constexpr double coarsest_m = 0.75;

/// Where nothing was seen in a square of this half width, there is no shadow: the robot did not get there.
constexpr int shadow_cells = 5;

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
    double worth_m2 = 0.0; ///< gain less the cost of its length
};

/// The hidden cells of an area, and what each line along one of the axes would show of them.
class HiddenCells {
public:
    explicit HiddenCells(const ScanLedger& ledger, double least_gain_m)
        : size_{ledger.columns(), ledger.rows()}
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
    /// The piece that is worth most; nullopt if none is worth anything.
    std::optional<Found> best() {
        std::optional<Found> best;
        for (int axis : {0, 1})
            for (int i = 0; i < static_cast<int>(lines_[axis].size()); ++i) {
                Line& line = lines_[axis][std::size_t(i)];
                if (std::exchange(line.changed, false))
                    line.best = bestPiece(line.gain_m2);
                if (line.best.worth_m2 > (best ? best->piece.worth_m2 : 0.0))
                    best = Found{axis, i * step_cells, line.best};
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
            const double worth_m2 = sum_m2 - least_gain_m_ * way_m;
            const double shown_m2 = sum_m2 + cost_m2 * (i + 1 - from);
            if (worth_m2 > best.worth_m2 && shown_m2 > least_m2)
                best = {from, i + 1, worth_m2};
        }
        return best;
    }

    int size_[2];
    double least_gain_m_;
    std::vector<float> hidden_; ///< share of each cell, row by row
    std::vector<Line> lines_[2];
};

} // namespace

std::vector<mapping::Lane> crossLanes(const ScanLedger& ledger, const LaneTerms& terms, const Vec2& from_m,
                                      const Vec2& home_m) {
    std::vector<mapping::Lane> lanes;
    if (terms.resolution_m > coarsest_m)
        return lanes;
    HiddenCells hidden(ledger, terms.least_gain_m);
    double left_m = terms.most_m;
    for (auto found = hidden.best(); found && left_m > least_lane_m; found = hidden.best()) {
        const auto most_cells = static_cast<int>(left_m / ScanLedger::cell_m);
        found->piece.to = std::min(found->piece.to, found->piece.from + most_cells);
        const auto at = [&](int along) {
            return found->axis == 0 ? ledger.centerOf_m(along, found->across) : ledger.centerOf_m(found->across, along);
        };
        lanes.push_back({at(found->piece.from), at(found->piece.to - 1), 0});
        left_m -= (found->piece.to - found->piece.from) * ScanLedger::cell_m;
        hidden.fly(*found);
    }
    orderTour(from_m, lanes, home_m);
    return lanes;
}

} // namespace usar::airrobot
