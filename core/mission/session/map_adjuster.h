// Makes the height map of a session again when the path of its robot is known better.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/mapping/lag_adjustment.h"
#include "core/mapping/map_rebuild.h"
#include "core/mapping/strip_adjustment.h"
#include "core/mission/session/scan_mapper.h"

namespace usar::mission {

/// Adjusts the strips of the kept scans (mapping::StripAdjustment), writes all scans into a new map with better cells
/// (mapping::MapRebuild) and replaces the mapper's map by it. The work is done in parts, so that the session can take
/// lines in between: a part for each line does not depend on how fast the machine is, and equal lines give equal maps.
/// A part takes some hundredths of a second, those of the adjustment up to three quarters after a flight of two hours,
/// which has some 200 parts. Scans that are placed meanwhile get into the new map, too. Belongs to a session and its
/// thread.
class MapAdjuster {
public:
    /// `mapper` must outlive this object. `emptyMap` makes the map without any scan.
    MapAdjuster(ScanMapper& mapper, std::function<mapping::HeightMap()> emptyMap)
        : mapper_(mapper)
        , emptyMap_(std::move(emptyMap))
        , flight_(mapper.store()) {}

    /// Begins to adjust all scans so far; a work that is under way is dropped.
    void begin();
    /// Takes note of the scans so far, so that `beginNoted` adjusts no others, whatever comes until then.
    void note();
    /// Begins to adjust what was noted last; does nothing if nothing was noted since the last `begin`.
    void beginNoted();
    /// True if scans were kept since the last `begin`.
    bool hasNews() const { return mapper_.store().scans().size() != scans_begun_ || mapper_.store().overfull(); }
    /// True if one of `shares` or more of all scans was kept since the last `begin`. A robot that lands again and
    /// again would otherwise spend most of the time on adjusting what was adjusted before.
    bool hasNews(std::size_t shares) const {
        return hasNews() && (shares - 1) * mapper_.store().scans().size() >= shares * scans_begun_;
    }
    bool busy() const { return adjustment_ || rebuild_; }
    /// Does a part of the work; returns false if there was none.
    bool step();
    /// Does a part of the adjustment of the newest strips in flight (mapping::LagAdjustment), unless `busy`, so that
    /// scans are placed by what it has found from then on. The map is not made again.
    void followFlight();
    /// Forgets everything, to be called when the mapper's map is emptied.
    void forget();
    /// The result that the mapper's map has; absent: it has not been adjusted yet.
    const std::optional<mapping::StripResult>& result() const { return result_; }
    /// The errors that are known of all sorties, by adjustments and in flight.
    const mapping::PathCorrection& correction() const { return flight_.correction(); }

private:
    /// The scans at a moment, and the sorties as they were then.
    struct Noted {
        std::size_t scans = 0;
        std::vector<mapping::Sortie> sorties;
    };
    void conclude();

    ScanMapper& mapper_;
    std::function<mapping::HeightMap()> emptyMap_;
    std::size_t scans_begun_ = 0;
    std::optional<Noted> noted_;
    std::optional<mapping::StripAdjustment> adjustment_;
    std::optional<mapping::StripResult> adjusted_; ///< of the map that is being made
    std::optional<mapping::MapRebuild> rebuild_;
    std::optional<mapping::StripResult> result_;
    mapping::LagAdjustment flight_;
};

} // namespace usar::mission
