// Tells what is seen of a cell from above where a scan has hit two things in it, as at the edge of a crown.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/mapping/edge_looks.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// The running mean of the thesis puts a cell at the edge of a crown or a roof somewhere between the ground and the
/// crown, wherever the last beams happened to hit, and nearly all of the error of a map is in these cells. Here the
/// hits in a cell are kept apart by height as two floors. Where a thing ends within half a meter, the cell gets the
/// height of the thing or that of the ground, by the share by which its center is covered (EdgeLooks). Other cells have
/// the mean of their hits. Takes 24 bytes a cell, and what EdgeLooks takes. A plain value that can be moved.
///
/// First all hits are added; then `findEdges` is called, then `look` for all scans, and at last `settle`.
class CellFloors {
public:
    /// `cell_size_m` is that of the map that will be settled.
    explicit CellFloors(double cell_size_m) : cell_size_m_(cell_size_m), looks_(cell_size_m) {}

    /// Takes a hit of a beam that came from `scanner_m`; map frame. Ignores points that are not finite.
    void add(const Vec3& scanner_m, const Vec3& hit_m);
    /// Finds the cells near which things end.
    void findEdges(const HeightMap& map);
    /// Takes a scan once more, for the cells at edges.
    void look(const Beams& beams, const Pose& scanner_in_map) { looks_.look(beams, scanner_in_map); }
    /// Gives the cells of `map` that were hit the heights that the hits tell. Cells that are only filled in stay,
    /// unless they are at an edge. An unknown cell at an edge is filled in where beams tell on which side of the edge
    /// it is, and that side was hit right beside it. No other unknown cell is.
    void settle(HeightMap& map) const;

private:
    /// Hits at about one height.
    struct Floor {
        float mean_m = 0.0f;
        float weight = 0.0f; ///< sum of the weights in the mean; 0: no hits
        float lowest_m = 0.0f;

        void take(const Floor& other);
    };
    struct Cell {
        Floor low, high;
    };
    using Tile = std::array<Cell, HeightTile::cell_count>;
    /// It holds the heights of both floors of a tile's cells and of a margin of two cells around the tile.
    struct Window;
    /// What is known near a cell at an edge: mean heights, and the sums of the weights in them.
    struct Sides {
        double ground_m = 0.0; ///< NaN where there is none; the same for the thing
        double grounds = 0.0;
        double thing_m = 0.0;
        double things = 0.0;
    };

    Tile& tileFor(GridIndex tile_index);
    Window windowAround(GridIndex tile_index, const HeightMap& map) const;
    /// `share` of the cell is covered; nullopt: that is not known. `at` is its place in the window.
    static float height_m(const Cell& cell, std::optional<double> share, const Window& window, std::size_t at);
    /// The height of a cell that nothing has hit; nullopt where that would be a guess.
    static std::optional<float> unhitHeight_m(double share, const Window& window, std::size_t at);

    double cell_size_m_;
    std::map<GridIndex, std::unique_ptr<Tile>> tiles_;
    std::pair<GridIndex, Tile*> last_{};
    EdgeLooks looks_;
};

} // namespace usar::mapping
