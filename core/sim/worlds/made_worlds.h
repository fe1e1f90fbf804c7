// The worlds that come with the program, each made from a seed (robots-and-worlds.md, section 5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// `tall_test`: 256 m x 256 m of wooded hills with a ravine, a pond and three houses.
/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 1": 1025 x 1025 posts, 2000 trees, 200 bushes.
/// Woods and open stretches alternate; around `PlayerStart` (60 m x 40 m and a margin) trees are farther apart. Heights
/// are whole steps of 1/1024 m and lengths whole millimeters, so that files keep them exactly.
World makeTallTest(std::uint64_t seed);

/// `vmac_room`: a closed hall with shelves and pillars, 40 m x 25 m x 6 m inside.
/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 2": floor, walls, ceiling, six pillars and nine
/// shelves, all boxes. The seed determines how high the shelves are and what is on them. Six RFID tags, two victims
/// with their gas, and an alarm are there for the sensors of ground robots.
World makeVmacRoom(std::uint64_t seed);

/// `spqr_soccer`: the field of a four-legged league with a loose ball.
/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 4": a carpet of 6 m x 4 m inside boards 0.1 m high,
/// two goals at its ends, four beacons beside it, and a ball in its middle, on a floor of 12 m x 10 m. Nothing in it is
/// random: all seeds give the same world.
World makeSpqrSoccer(std::uint64_t seed);

inline constexpr double ball_radius_m = 0.043;

/// `point_lookout`: a square kilometer of sea around a wooded island with cliffs and beaches.
/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 3": 1025 x 1025 posts 1 m apart, the sea's surface
/// at 0 and its bed down to -25 m, 3000 trees on land. The start poses `OpenSea`, `NorthSea` and `Bay` are a meter
/// above deep water, for a submarine to fall in. Heights are whole steps of 1/512 m.
World makePointLookout(std::uint64_t seed);

/// Rows are lines of the file, columns are numbers in a line.
struct ElevationTable {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> heights_m; ///< row by row

    double at(std::size_t row, std::size_t column) const { return heights_m[row * columns + column]; }
};

/// Reads lines of equally many numbers with commas between them, at least 4 x 4. An error names the wrong line.
Result<ElevationTable> readElevationCsv(const std::filesystem::path& file);

/// Largest difference between the world and its source at the source's posts.
inline constexpr double volcano_noise_m = 0.4;
inline constexpr double volcano_post_m = 10.0; ///< distance between the source's posts

/// `volcano`: a real hill with a crater, 860 m x 600 m, from measured heights.
/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 5": cubic splines through the source's posts,
/// sampled every 0.5 m, with a little noise on scales below 10 m that fades out where robots start. The table's rows
/// run to the north, which is x, and its columns to the west, which is y; heights are above sea level. 300 trees.
World makeVolcano(const ElevationTable& source, std::uint64_t seed);

/// Height of the upper floor of `warehouse`.
inline constexpr double mezzanine_m = 3.5;

/// `warehouse`: a closed hall of 40 m x 30 m x 9 m with six rows of racks, a mezzanine, a ramp of 10 degrees up to it,
/// and a second room with a dock behind two doorways. All but the loose crates, boxes and barrels are boxes. The seed
/// determines where the cross aisle and the doorways are, how high the racks are and what stands on them.
World makeWarehouse(std::uint64_t seed);

inline constexpr double wire_m = 0.03; ///< thickness of the wires in `town`

/// `town`: 120 m x 120 m of rolling ground with three streets each way, some fifty houses, and a square with a church.
/// Masts, which are trunks without crowns, stand on the sidewalks; wires hang between their tops, across streets and
/// along one, in four straight pieces each. The seed determines the streets, the houses, the trees and the wires.
World makeTown(std::uint64_t seed);

/// `quarry`: a pit of 150 m x 150 m with four faces of 4.5 m to 7.5 m, benches between them, and a pond at its bottom.
/// A road leads down in one turn. Ledges of rock jut out over benches, and boulders lie about; both are boxes, and the
/// ledges are those that lie level. Trees stand around the pit. 601 x 601 posts 0.25 m apart.
World makeQuarry(std::uint64_t seed);

} // namespace usar::sim
