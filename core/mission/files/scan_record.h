// Results of a mission: the height map, the path and the marks, the robot and behavior that made them, and the metadata
// in every file, so that each can be understood on its own years later.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/agent/published.h"
#include "core/mapping/raster_export.h"
#include "core/mapping/scan_store.h"
#include "core/mapping/strip_result.h"
#include "core/mission/files/coverage_course.h"

namespace usar::mission {

/// An earlier run that was cut off, and which the run of a record continues: what came before is in the map.
struct ContinuedRun {
    QString recording;     ///< full path of its recording
    Seconds duration{0.0}; ///< on the protocol clock, with the runs that it continued itself; so are the next two
    double distance_m = 0.0;
    int charges = 0;
    std::size_t cells = 0; ///< known cells that were taken over
};

/// A point of the corrected path: a scan's place as it was estimated and as it is now believed, with its standard
/// deviation. Meters, map frame.
struct CorrectedPoint {
    Seconds time{0.0}; ///< since the first scan of the session
    Vec3 estimated_m = Vec3::Zero();
    Vec3 corrected_m = Vec3::Zero();
    Vec3 sigma_m = Vec3::Zero();
};

/// How far a correction has moved the path, in meters; over all its points.
struct PathShift {
    double mean_m = 0.0;
    double greatest_m = 0.0;
};

/// What an adjustment of the strips has done to the map, see mapping::StripResult.
struct MapAdjustment {
    mapping::AdjustmentVerdict verdict = mapping::AdjustmentVerdict::Declined;
    std::string reason{};
    std::optional<double> residual_before_m{};
    std::optional<double> residual_after_m{};
    std::size_t overlaps = 0;
    std::optional<PathShift> shift{}; ///< absent if the adjustment was declined; so is the next
    /// The corrected path from above, made once for each adjustment and shared with whoever shows it.
    std::shared_ptr<const std::vector<Vec2>> corrected_m{};
    // The rest is filled only when the record is handed out, and empty if the adjustment was declined.
    std::vector<CorrectedPoint> path{}; ///< at least a cell apart
    /// Standard deviation of the heights as far as it comes from that of the path, on the grid of the record's raster;
    /// NaN where the height is unknown.
    mapping::Raster deviation{};
};

/// A plain value that crosses threads. Positions in meters, map frame. The height map itself stays with its session;
/// exports are made from `raster`.
struct ScanRecord {
    std::string robot_name;
    std::string behavior_id;
    std::string level;     ///< name of the server's map; empty: unknown
    Rectangle area_in_map; ///< mission area; empty: none
    std::vector<agent::MapMark> marks;
    std::vector<Vec3> path_m;     ///< estimated positions of the robot, at least a cell apart
    agent::BehaviorStatus status; ///< newest one
    /// Faults that were made to happen during the scan, in words: "60.2 s: fault begins: wind speed=5".
    std::vector<std::string> faults;
    CoverageCourse course;
    std::optional<ContinuedRun> continues{};   ///< absent: the scan began with this run
    std::optional<MapAdjustment> adjustment{}; ///< absent: nobody wanted it, or nothing was adjusted yet
    /// Grows with every change worth saving: map, path, marks, and in the status its words, charges and distance. With
    /// an empty map nothing is worth saving, so it begins at 0.
    std::uint64_t revision = 0;
    /// The scans of the map with their final poses, for exports of points; null: nobody wanted them, or they were not
    /// kept, or dropped (mapping::ScanStore). Filled when the record is handed out.
    std::shared_ptr<const std::vector<mapping::KeptScan>> scans{};
    mapping::Raster raster; ///< filled when the record is handed out
    /// Parts of the map too far from the rest to be in one raster with it: saved as raw heights, in no picture.
    std::vector<mapping::Raster> far_rasters;
    std::size_t cells_left_out = 0; ///< known cells in places even farther away, which are not saved
};

/// Number of known cells in `raster` and `far_rasters`.
inline std::size_t knownCellCount(const ScanRecord& record) {
    std::size_t count = record.raster.knownCellCount();
    for (const mapping::Raster& far : record.far_rasters)
        count += far.knownCellCount();
    return count;
}

/// Keys and values, in this order: level, robot, behavior, axes, units, cell size, center of the upper left cell
/// (meters, map frame), faults if there were any, lowest and highest height (missing for an empty map). Keys carry
/// their unit.
std::vector<std::pair<QString, QString>> metadataOf(const ScanRecord& record);

/// Converts each of the texts.
QStringList textsOf(const std::vector<std::string>& texts);

/// Formats a number with up to twelve significant digits; C locale.
QString numberText(double value);

} // namespace usar::mission
