// A made-up scan with hills, trees and every kind of mark: what picture and result tests work on.
#pragma once

#include <cmath>

#include "core/mission/files/scan_record.h"

/// `side` x `side` cells around the origin, with an unknown corner at the lowest x and y.
inline usar::mission::ScanRecord sampleScan(int side, double cell_size_m = 0.25) {
    using namespace usar;
    using agent::MarkKind;
    mission::ScanRecord record;
    record.robot_name = "R1";
    record.behavior_id = "airrobot/cpp";
    record.level = "tall_test";
    const double half_m = side * cell_size_m / 2;
    record.area_in_map = {{-half_m, -half_m}, {half_m, half_m}};
    record.raster.columns = record.raster.rows = side;
    record.raster.cell_size_m = cell_size_m;
    record.raster.upper_left_center_m = Vec2(-half_m + cell_size_m / 2, half_m - cell_size_m / 2);
    record.raster.heights_m.resize(std::size_t(side) * std::size_t(side));
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double x = column * cell_size_m, y = row * cell_size_m;
            const bool tree = std::fmod(x + 3 * std::sin(y), 7) < 2 && std::fmod(y + 2 * std::sin(x), 9) < 2;
            const double height_m = 3 * std::sin(x / 9) + 2 * std::cos(y / 7 + x / 20) + (tree ? 5 : 0);
            const bool unknown = column < side / 5 && row > side - side / 5;
            record.raster.heights_m[std::size_t(row) * std::size_t(side) + std::size_t(column)] =
                unknown ? NAN : float(height_m);
        }
    }
    for (int lane = 0; lane < 4; ++lane) {
        const double y = half_m * (0.75 - 0.5 * lane);
        for (double s = -half_m; s < half_m; s += 0.2)
            record.path_m.push_back({(lane % 2 == 0 ? s : -s), y + std::sin(s / 4), 6});
    }
    for (int i = 0; i < 6; ++i) {
        const double x = half_m * (-0.8 + 0.3 * i);
        record.marks.push_back({MarkKind::Diversion, {x, half_m * 0.55, 6}, Seconds{10.0 + i}, {}});
        record.marks.push_back({MarkKind::LowRisk, {x, half_m * 0.3, 6}, Seconds{20.0 + i}, {}});
        record.marks.push_back({MarkKind::HighRisk, {x, -half_m * 0.1, 6}, Seconds{30.0 + i}, {}});
    }
    record.marks.push_back({MarkKind::Recharge, {half_m * 0.5, -half_m * 0.5, 6}, Seconds{40.0}, {}});
    record.marks.push_back({MarkKind::Landing, {0, 0, 0}, Seconds{50.0}, {}});
    record.marks.push_back({MarkKind::GoalGivenUp, {-half_m * 0.5, -half_m * 0.4, 6}, Seconds{60.0}, {}});
    record.marks.push_back({MarkKind::Path, {1, 1, 6}, Seconds{61.0}, {}});
    return record;
}
