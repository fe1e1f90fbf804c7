// Tells what is seen of a cell from above where a scan has hit two things in it, as at the edge of a crown.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "core/mapping/height_map.h"

namespace usar::mapping {

/// The running mean of the thesis puts a cell at the edge of a crown or a roof somewhere between the ground and the
/// crown, wherever the last beams happened to hit, and nearly all of the error of a map is in these cells. Here the
/// hits in a cell are kept apart by height as two floors, and the height is their mean, weighted by how likely the
/// higher floor covers the cell's center:
/// - A beam that hits the higher floor before it has passed the center speaks for it, because a thing goes on behind
///   the place where it is hit. One that has passed the center speaks against it if nothing lower was hit.
/// - A beam that reaches the lower floor speaks against it, the more the steeper it is: flat ones see the ground below
///   a crown.
/// - The neighboring cells that are as high speak for it.
/// Hits near the center count more than others. A cell with one floor has the mean of its hits, unless it is the edge
/// of something whose hits are all on the far side of the center; then the height is that of its neighbors below.
/// The weights were chosen by comparison with true heights in one wooded world: they make open ground more exact, and
/// crowns, too, where most of the ground is seen twice; where it is not, crowns end too early and become less exact.
/// Takes 36 bytes a cell. A plain value that can be moved.
class CellFloors {
public:
    /// `cell_size_m` is that of the map that will be settled.
    explicit CellFloors(double cell_size_m) : cell_size_m_(cell_size_m) {}

    /// Takes a hit of a beam that came from `scanner_m`; map frame. Ignores points that are not finite.
    void add(const Vec3& scanner_m, const Vec3& hit_m);
    /// Gives the cells of `map` that were hit the heights that the hits tell. Cells that are only filled in stay,
    /// unless they are at an edge: there the neighbors tell.
    void settle(HeightMap& map) const;

private:
    /// Hits at about one height.
    struct Floor {
        float mean_m = 0.0f;
        float weight = 0.0f; ///< sum of the weights in the mean; 0: no hits
        float before = 0.0f; ///< votes of beams that hit it before they passed the center of the cell
        float after = 0.0f;  ///< votes of those that had passed it

        void take(const Floor& other);
    };
    struct Cell {
        Floor low, high;
        float down = 0.0f; ///< votes of steep beams that hit the low floor
    };
    using Tile = std::array<Cell, HeightTile::cell_count>;
    /// It holds the heights of both floors of a tile's cells and of a margin of two cells around the tile.
    struct Window;

    Tile& tileFor(GridIndex tile_index);
    Window windowAround(GridIndex tile_index, const HeightMap& map) const;
    static float height_m(const Cell& cell, const Window& window, std::size_t at);

    double cell_size_m_;
    std::map<GridIndex, std::unique_ptr<Tile>> tiles_;
    std::pair<GridIndex, Tile*> last_{};
};

} // namespace usar::mapping
