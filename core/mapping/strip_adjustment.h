// Corrects the path of a robot by the overlap of the strips that it scanned: strip adjustment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/mapping/strip_overlaps.h"
#include "core/mapping/strip_residual.h"
#include "core/mapping/strip_result.h"
#include "core/mapping/strip_solver.h"

namespace usar::mapping {

/// The method is that of the adjustment of laser scanning strips (Ressl et al., 2011, "Applying 3D affine
/// transformation and least squares matching for airborne laser scanning strips adjustment without GNSS/IMU trajectory
/// data"), with the errors of a path instead of those of whole strips: unknown is the error of x, y, z
/// and yaw at knots that are 5 s apart (StripSolver); observed are differences in height between looks at one cell
/// (StripHits), linearized by the slope of the map. The grids become finer, from 2 m to 0.5 m, as the errors become
/// smaller; those of an area of more than a square kilometer stay coarser. Roll and pitch are taken as they are.
///
/// A correction is accepted only if the differences in height become smaller by it (StripResidual), and only if the
/// ground gives hold in at least one horizontal direction: over flat ground all positions give the same heights. Where
/// the ground holds one direction only, as in a straight valley, the error in the other one is the most likely one
/// without overlaps.
///
/// Works in steps, so that whoever owns it can do something else in between. For a flight of two
/// hours a step takes a quarter of a second, and the last one three quarters. Uses nothing but what the robot has told;
/// equal scans give equal results.
class StripAdjustment {
public:
    /// `store` must outlive this object, and may grow meanwhile; what comes later is not adjusted.
    explicit StripAdjustment(const ScanStore& store) : StripAdjustment(store, store.scans().size(), store.sorties()) {}
    /// Adjusts the first `scan_count` scans, whose sorties were `sorties` then.
    StripAdjustment(const ScanStore& store, std::size_t scan_count, std::vector<Sortie> sorties);

    /// Does a part of the work; returns false when `result` is final.
    bool step();
    const StripResult& result() const { return result_; }

private:
    void begin();
    void look();
    void refine();
    void judge();
    void accept(AdjustmentVerdict verdict, const KnotErrors& errors, const StripResidual& residual,
                const std::vector<Eigen::Matrix4d>& covariances);
    StripResidual residualWith(const KnotErrors& errors) const;
    void decline(const std::string& reason);
    void bridgeOrDecline(const std::string& reason);

    const ScanStore* store_;
    std::vector<Sortie> sorties_; ///< as they were when the work began
    std::size_t scan_count_ = 0;
    std::size_t next_ = 0; ///< number of the next step
    KnotTimes knots_;
    StripHits hits_;
    double finest_m_ = 0.0; ///< side of the smallest cells
    std::optional<StripSolver> solver_;
    KnotErrors errors_;
    KnotErrors bridged_;                               ///< errors without any overlap
    std::vector<Eigen::Matrix4d> bridged_covariances_; ///< their covariances
    StripResidual residual_;                           ///< It belongs to the path as it was estimated.
    StripResidual residual_bridged_;
    StripResult result_;
};

} // namespace usar::mapping
