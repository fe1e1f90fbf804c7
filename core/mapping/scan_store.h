// Keeps the scans of a mission, so that its map can be made again when the robot's path is known better.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/mapping/scan_integrator.h"

namespace usar::mapping {

/// A flight between two settings of the INS. Its position is exact at the beginning and drifts from then on.
struct Sortie {
    Seconds begin{0.0}; ///< time of its first estimate
    Seconds end{0.0};   ///< time of its newest estimate
    /// Sum of the squares of the steps between estimates, in m²: the INS adds noise to each step in proportion to its
    /// length (robots-and-worlds.md 4.4), so the variance of its position grows with this sum.
    double walk_m2 = 0.0;
    /// How wrong the last estimate was (estimate minus truth, map frame), as the next setting of the INS has shown;
    /// absent: nothing has shown it.
    std::optional<Vec3> closing_error_m{};
};

/// A scan of the map with everything that is needed to write it again.
struct KeptScan {
    Seconds time{0.0};     ///< The estimate that placed it is of this time, on the store's clock.
    Pose scanner_in_map{}; ///< as it was placed
    LineNumber line{};     ///< info line in which it came
    double walk_m2 = 0.0;  ///< Sortie::walk_m2 at that time
    std::uint32_t sortie = 0;
    std::uint32_t scanner = 0; ///< number of the scanner, whose scans are joined to strips
    bool continues = false;    ///< the scanner's previous scan is joined to this one
    std::vector<float> ranges_m{};
    double resolution_rad = 0.0; ///< this and the rest as in Beams
    double fov_rad = 0.0;
    double maximum_m = 20.0;

    /// The beams; `ranges_m` is where their ranges are put, and must outlive them.
    Beams beams(std::vector<double>& ranges_m) const;
};

/// Scans and sorties in order. A scan of 181 beams takes 0.9 kB, so the 36 000 scans of a flight of two hours take 32
/// MB; above `most_bytes`, which is about 14 hours of flight, everything is forgotten and nothing is kept any more. Its
/// clock is that of the protocol, except that it never runs backward when a new connection begins with a new clock.
/// Belongs to one session.
class ScanStore {
public:
    static constexpr std::size_t most_bytes = std::size_t(256) << 20;

    /// Takes the robot's estimate of its position; call it for every estimate.
    void move(Seconds now, const Vec3& base_in_map_m);
    /// The INS was set: what it had told as `from_m` is `to_m`. A new sortie begins.
    void insWasSet(const Vec3& from_m, const Vec3& to_m);
    /// A new connection begins: the robot is a new one, and how wrong the last estimate was stays unknown.
    void interrupt();
    /// Keeps a scan that was placed now; fills in its time, sortie and walk.
    void keep(KeptScan scan);
    void clear() { *this = {}; }
    /// Whether the estimates have no errors, as those of a robot that is told where it really is.
    void setExact(bool exact) { exact_ = exact; }
    bool exact() const { return exact_; }

    /// Valid until the store is cleared or overfull; kept scans stay where they are.
    const std::deque<KeptScan>& scans() const { return scans_; }
    const std::vector<Sortie>& sorties() const { return sorties_; }
    bool overfull() const { return overfull_; }
    std::size_t memoryBytes() const { return bytes_; }

private:
    std::deque<KeptScan> scans_;
    std::vector<Sortie> sorties_;
    std::optional<Vec3> last_m_;
    Seconds shift_{0.0}; ///< from the protocol's clock to the store's
    bool new_clock_ = false;
    bool new_sortie_ = true;
    bool overfull_ = false;
    bool exact_ = false;
    std::size_t bytes_ = 0;
};

} // namespace usar::mapping
