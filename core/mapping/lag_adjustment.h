// Corrects the path of a robot in flight, by what it scanned before.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/mapping/path_correction.h"
#include "core/mapping/scan_store.h"
#include "core/mapping/strip_overlaps.h"
#include "core/mapping/strip_solver.h"

namespace usar::mapping {

/// A smoother with a fixed lag: every `interval` of a flight, the errors of its last `lag` are sought again, by the
/// overlaps of these strips with each other and with what was scanned before them. What is older than the lag stays as
/// it was found, until all strips are adjusted together (StripAdjustment), which is more exact and takes longer. The
/// method and the unknowns are the same. The error at the beginning of the lag is taken as known; the random walk
/// leaves the path room to lead away from it.
///
/// What a pass has found is taken only if the heights do not agree worse by it than by what was known before, and only
/// if the ground gives hold in at least one horizontal direction.
///
/// Works in steps of some milliseconds, seven each pass. Uses nothing but what the robot has told; equal
/// scans give equal results. Belongs to the owner of the store.
class LagAdjustment {
public:
    static constexpr Seconds lag{120.0};
    static constexpr Seconds interval{15.0};

    /// `store` must outlive this object.
    explicit LagAdjustment(const ScanStore& store) : store_(&store) {}

    /// Takes over what an adjustment of all strips has found; a pass that is under way is dropped.
    void take(const PathCorrection& correction);
    /// Does a part of the work; returns false if there is none, because the last pass began less than `interval` ago.
    bool step();

    /// The errors of all sorties, as far as they are known.
    const PathCorrection& correction() const { return correction_; }
    /// The error now; zero if none was found since the INS was set.
    PathKnot newest() const;

private:
    /// The scans of a pass and what is sought. Its first sortie is none: the scans before the lag are in it, all at the
    /// same moment, because they are taken as placed rightly.
    struct Pass {
        std::size_t sortie = 0; ///< number of the sortie in the store
        Seconds from{0.0};      ///< beginning of the lag
        PathKnot known;         ///< the error then
        std::vector<Sortie> sorties;
        std::vector<KeptScan> scans; ///< those within the lag without the known error
        std::optional<KnotTimes> knots;
        StripHits hits;
        std::optional<StripSolver> solver;
        std::vector<Eigen::Matrix4d> free_covariances; ///< those without overlaps
        KnotErrors before; ///< what was known before, relative to the error at the beginning
        KnotErrors errors;
        std::size_t next = 0; ///< number of the next step
    };

    bool begin();
    void gather();
    void prepare();
    void conclude();
    /// Whether the overlaps say that the new errors are better than those known before.
    bool isBetter() const;

    const ScanStore* store_;
    PathCorrection correction_;
    std::optional<Seconds> last_; ///< time at which the last pass began
    std::optional<Pass> pass_;
};

} // namespace usar::mapping
