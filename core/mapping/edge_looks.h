// Tells how likely the edge of a thing, such as a crown, covers a place, by the beams that hit it and those that
// passed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/mapping/beam_hits.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// At the edge of a crown a cell has few hits, and none of them is just at its center. But each beam tells something
/// about the outline of the crown: one that hits it was inside of the outline, and one that went down through the
/// height at which the crown is widest without a hit was outside there, whatever it hit below; ground that was seen
/// below a crown therefore says nothing. These places within half a meter are the points of a local linear regression
/// (Cleveland 1979, "Robust locally weighted regression and smoothing scatterplots"; here without the robust weights)
/// of covered (1) and open (0), whose value at the center of the cell is the share by which it is covered. So a
/// straight outline is found between the points on both sides of it, where counting the points of one cell would find
/// nothing.
///
/// First all edges are added, then all scans are looked at. Takes 56 bytes for a cell at an edge. A plain value that
/// can be moved.
class EdgeLooks {
public:
    explicit EdgeLooks(double cell_size_m) : cell_size_m_(cell_size_m) {}

    struct Edge {
        float level_m = 0.0f; ///< height of the outline
        float least_m = 0.0f; ///< Hits above it are on the thing.
    };
    /// Adds a cell that may be at an edge, once.
    void addEdge(GridIndex cell, const Edge& edge);
    /// Takes a scan.
    void look(const Beams& beams, const Pose& scanner_in_map);
    /// The share by which the center of a cell is covered, about 0 to 1 but not limited to that; nullopt where too
    /// little was seen, and for other cells.
    std::optional<double> coveredShare(GridIndex cell) const;

private:
    /// A cell, and sums over the points in it from which the regression is made.
    struct Cell {
        Edge edge;
        Eigen::Matrix3f normal = Eigen::Matrix3f::Zero();  ///< of the products of 1, x and y from the center, in meters
        Eigen::Vector3f covered = Eigen::Vector3f::Zero(); ///< of 1, x and y of the points that are covered
    };
    using Numbers = std::array<std::uint32_t, HeightTile::cell_count>; ///< of cells, from 1; 0: no edge

    /// Nullptr where there is no edge.
    Cell* cellAt(GridIndex cell);
    const Cell* cellAt(GridIndex cell) const;
    void takeHits(const Vec3& scanner_m);
    void takePasses(Cell& cell, const Vec2& center_m, const Beams& beams, const Pose& scanner);

    double cell_size_m_;
    std::map<GridIndex, std::unique_ptr<Numbers>> tiles_;
    mutable std::pair<GridIndex, const Numbers*> last_{};
    std::vector<Cell> cells_;
    HitFinder finder_;
    BeamDirections directions_;
    std::vector<Vec3> hits_m_; ///< of the present scan
    Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
};

} // namespace usar::mapping
