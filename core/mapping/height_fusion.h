// One height map made of those of several robots.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/base/robot_id.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Whose heights a view shows: those of all robots in one map, or those of the selected robot only.
enum class HeightScope { AllRobots, SelectedRobot };

/// A part of a height map that has changed since it was last told.
struct HeightChange {
    bool from_scratch = false; ///< what was told before is void; `tiles` are all there are
    double cell_size_m = 0.25; ///< side of the tiles' cells
    std::vector<std::shared_ptr<const HeightTile>> tiles;
    std::optional<HeightRange> range; ///< of the whole map; nullopt: the map is empty
};

/// The rule for a cell is that of one map (HeightMap::write and fill), without its order of arrival:
/// - Measured values rule out those that were only filled in between beams. Both rules below look at what is left.
/// - Height and preview are the mean of the robots' values, each counted once. A robot's value is already the mean of
///   its own measurements, in which the newest one weighs half (thesis 4.2), so more hits do not make it more exact.
/// - Hits are the sum of all hits, saturating. The line is that of the only robot that knows the cell; 0 if several do,
///   because lines of different connections have nothing to do with each other.
///
/// So the map of one robot stays as it is, bit for bit. The order in which robots and tiles arrive does not matter, and
/// when a robot leaves, the map is as if it had never been there.
///
/// The grid is that of the robot with the smallest cells. A larger cell of another robot gives its values to every cell
/// whose center it covers.
///
/// Tiles arrive as copies that nobody changes any more. A place that only one robot has scanned shares its tile, so
/// that time and memory are spent only where scans overlap. Reads no clock; belongs to one thread.
class HeightFusion {
public:
    /// Takes new or changed tiles of a robot's map, whose cells have this size. A changed size means another map, which
    /// replaces the robot's earlier one. `from_scratch`: its earlier tiles are void.
    void take(ConnectionId robot, double cell_size_m, const std::vector<std::shared_ptr<const HeightTile>>& tiles,
              bool from_scratch = false);
    /// Forgets a robot; an unknown one changes nothing.
    void remove(ConnectionId robot);

    /// True if `takeChange` has something to tell.
    bool changed() const { return from_scratch_ || !dirty_.empty(); }
    /// Fuses what has changed since the last call.
    HeightChange takeChange();
    /// The fused map as of the last `takeChange`.
    const HeightTiles& tiles() const { return fused_; }
    double cellSize_m() const { return cell_size_m_; }

private:
    struct Source {
        double cell_size_m = 0.25;
        HeightTiles tiles; ///< never empty
    };
    /// Marks what this tile covers as changed.
    void touch(GridIndex tile, double cell_size_m);
    void touchAll(const Source& source);
    /// Starts over if the smallest cells have another size now.
    void chooseGrid();
    /// The fused tile; nullptr where no robot has one.
    std::shared_ptr<const HeightTile> fuse(GridIndex tile) const;

    std::map<ConnectionId, Source> sources_;
    double cell_size_m_ = 0.25;
    HeightTiles fused_;
    std::map<GridIndex, std::optional<HeightRange>> ranges_; ///< by fused tile
    std::set<GridIndex> dirty_;                              ///< fused tiles that must be made again
    bool from_scratch_ = false;
};

} // namespace usar::mapping
