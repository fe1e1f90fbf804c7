// Makes a height map again from kept scans, with a corrected path.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "core/mapping/cell_floors.h"
#include "core/mapping/height_map.h"
#include "core/mapping/path_correction.h"
#include "core/mapping/scan_integrator.h"
#include "core/mapping/scan_store.h"

namespace usar::mapping {

/// Writes the scans in the order in which they came, so that without a correction the same cells are known again. At
/// the end, each measured height becomes the one that CellFloors tells, instead of the running mean of the thesis,
/// which a map has while it is flown and as long as nobody asks for an adjustment; CellFloors adds cells along
/// outlines, too. Works in steps, so that whoever owns it can do something else in between; a step takes
/// `scans_per_step` scans and about 10 ms, first to write all of them and then to look at the edges of things. The last
/// step settles all cells, which takes longer the larger the map is.
class MapRebuild {
public:
    static constexpr std::size_t scans_per_step = 200;

    /// `map` is what was known before the first scan, usually nothing. `store` must outlive this object and may grow
    /// meanwhile: new scans are written, too.
    MapRebuild(const ScanStore& store, PathCorrection correction, HeightMap map)
        : store_(&store)
        , correction_(std::move(correction))
        , map_(std::move(map))
        , floors_(map_.cellSize_m()) {}

    /// Writes some scans; returns false if there are no more.
    bool step();
    HeightMap takeMap() { return std::move(map_); }

private:
    void write(const KeptScan& scan);

    const ScanStore* store_;
    PathCorrection correction_;
    HeightMap map_;
    CellFloors floors_;
    std::map<std::uint32_t, ScanIntegrator> integrators_; ///< by scanner
    std::vector<double> ranges_m_;
    std::size_t next_ = 0;   ///< number of the next scan to be written
    std::size_t looked_ = 0; ///< So many have been looked at for the cells at edges.
};

} // namespace usar::mapping
