// Results of one robot's scan that its session keeps: the height map, the path, the marks, and whose they are.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mission/files/scan_record.h"
#include "core/mission/session/earlier_scan.h"
#include "core/mission/session/map_adjuster.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/scan_mapper.h"

namespace usar::mission {

/// Outlives connections and behaviors; only a replay that starts again empties it. Belongs to one session and its
/// thread.
class ScanBook {
public:
    /// `notices` must outlive this object.
    ScanBook(double cell_size_m, Notices& notices)
        : notices_(notices)
        , mapper_(cell_size_m)
        , adjuster_(mapper_, [this] { return emptyMap(); }) {}

    /// Forgets unplaced scans: on a new connection they can no longer be matched with their placements.
    void beginConnection() { mapper_.forgetScans(); }
    /// Forgets everything except the level.
    void rewind();
    /// Prepares an empty map for a replay. Without a size the cell size stays the same.
    void beginReplay(std::optional<double> cell_size_m, const std::string& level);
    void beginTask(const std::string& behavior_id, const std::string& robot_name, const Rectangle& area_in_map);

    /// Takes over what an earlier run scanned, unless the map has heights already. The next task counts as a part of
    /// that run's: the record keeps the area of the whole.
    void continueScan(const EarlierScan& earlier);

    /// Also does a part of an adjustment that is under way.
    void take(const protocol::InfoLine& line);
    void take(const agent::Published& value);
    /// Takes a command that was sent, now or in a replay.
    void takeSent(const protocol::Command& command) { mapper_.takeSent(command); }
    /// Keeps a status that is only passed on the way to another moment of a replay.
    void passStatus(const agent::BehaviorStatus& status) { record_.status = status; }
    void noteFault(const std::string& sentence) { record_.faults.push_back(sentence); }
    /// Whether the map is adjusted (MapAdjuster) at the end of each task and at landings; otherwise it is that of the
    /// thesis. It is unless this is called before the first scan.
    void setAdjust(bool on);
    /// Whether it is adjusted at each landing, for somebody who watches it grow, in a flight or in a replay. It takes
    /// 0.3 to 0.4 % of one processor while a flight of up to two hours is watched. Landings before which less than a
    /// twentieth of all scans was new are left out, so that it stays below 2 % in longer ones. Initially off: only
    /// landings before which half of all scans or more were new count, and all of them together take no longer than
    /// the end. The map of the end is the same.
    void adjustAtEachLanding(bool on) { landing_shares_ = on ? 20 : 2; }
    /// What comes from now on is only passed on the way to another moment of a replay. Of the landings and the ends of
    /// tasks there, only the newest counts, and its adjustment begins when the way is over.
    void passOn(bool on);
    /// Whether the newest strips are also adjusted in flight (MapAdjuster::followFlight), so that the map is better
    /// while it grows; that of the end is the same. It takes 10 to 50 ms of processor time in 15 s of flight; initially
    /// off.
    void adjustInFlight(bool on) { adjusts_in_flight_ = on; }
    /// Whether scans are kept for exports of points, in 0.9 kB each; initially they are only where the map is adjusted.
    void keepScans(bool on) { mapper_.keepScans(on); }
    /// The task is over: begins to adjust the map. A part follows with each line, or with `adjustPart`.
    void endTask() { beginAdjustment(); }
    /// Does a part of an adjustment that is under way; returns false if there is none, or if it waits for `passOn`.
    bool adjustPart();
    /// Adjusts the map with all scans that are there, which may take some seconds.
    void finishAdjustment();
    /// Refused with a notice once the map has heights.
    void setCellSize(double cell_size_m);

    /// The corrected path as MapAdjustment has it; null: the map is not corrected.
    std::shared_ptr<const std::vector<Vec2>> correctedPath_m() const {
        return record_.adjustment ? record_.adjustment->corrected_m : nullptr;
    }
    /// The record without its raster, which only `snapshot` fills in.
    const ScanRecord& record() const { return record_; }
    /// `with_scans`: also the scans, as far as they were kept.
    ScanRecord snapshot(bool with_scans = false) const;
    /// The kept scans, corrected by what is known of their errors now, behind those of an earlier run; null if they
    /// were dropped.
    std::shared_ptr<const std::vector<mapping::KeptScan>> placedScans() const;
    double cellSize_m() const { return mapper_.map().cellSize_m(); }
    ScanMapper& mapper() { return mapper_; }

private:
    void takePlacement(const agent::ScanPlacement& placement);
    void takeStatus(const agent::BehaviorStatus& status);
    void takePose(const agent::PoseEstimate& estimate);
    void beginAdjustment();
    /// An adjustment waits until the way to another moment is over.
    bool waits() const;
    /// The map without the scans of this run.
    mapping::HeightMap emptyMap() const;
    /// The path of the kept scans as they were placed and as they are corrected, at least a cell apart; empty without a
    /// correction.
    std::vector<CorrectedPoint> correctedPath() const;
    /// Fills in the corrected path and the deviation of a copy with its raster.
    void describeAdjustment(ScanRecord& copy) const;
    void worthSaving() { record_.revision += mapper_.map().knownCellCount() > 0 ? 1 : 0; }

    Notices& notices_;
    ScanMapper mapper_;
    MapAdjuster adjuster_;
    bool adjusts_ = false;
    bool adjusts_in_flight_ = false;
    std::size_t landing_shares_ = 2; ///< One of so many shares of all scans must be new at a landing.
    bool passes_on_ = false;
    mapping::HeightTiles earlier_tiles_; ///< what an earlier run has scanned
    ScanRecord record_;
    std::optional<Rectangle> whole_area_in_map_; ///< area of the next task's record; absent: that of the task
    bool unplaced_said_ = false;
};

} // namespace usar::mission
