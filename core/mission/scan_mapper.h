// Keeps the newest scans until a behavior says where they were taken, and writes them into the height map.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "core/agent/published.h"
#include "core/mapping/height_map.h"
#include "core/mapping/scan_integrator.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// A behavior places a scan in the tick that follows it or soon after, so a few scans of each scanner are enough.
/// Strips are joined scanner by scanner. Scanners beyond `scanner_limit` (garbled names) share one place. Owned by one
/// session.
class ScanMapper {
public:
    static constexpr std::size_t shelf_size = 8;
    static constexpr std::size_t scanner_limit = 16;

    explicit ScanMapper(double cell_size_m) : map_(cell_size_m) {}

    void takeScan(const protocol::RangeScan& scan, LineNumber line);
    /// CONF of scanners: their maximum range, at and beyond which a beam hit nothing. 20 m until it is known.
    void takeConfiguration(const protocol::ConfigurationInfo& configuration);
    /// False when the scan is not on the shelf (any more). Scans that do not follow one another are not joined.
    bool place(const agent::ScanPlacement& placement);
    /// A new connection: line numbers of the old one mean nothing now. The map stays.
    void forgetScans();
    /// An empty map; `cell_size_m` of its cells stays as it is where it is not given.
    void clearMap(std::optional<double> cell_size_m = {});

    mapping::HeightMap& map() { return map_; }
    const mapping::HeightMap& map() const { return map_; }
    /// Of the newest placed scan, whichever scanner took it.
    const std::vector<Vec3>& lastHits() const { return last_hits_; }

private:
    struct Shelved {
        protocol::RangeScan scan;
        LineNumber line;
        std::uint64_t ordinal = 0; ///< scans of a scanner on a connection counted from 1
    };
    struct Scanner {
        mapping::ScanIntegrator integrator;
        std::array<Shelved, shelf_size> shelf;
        std::uint64_t scans_taken = 0;
        std::uint64_t last_placed = 0;
    };
    Scanner& scannerNamed(const std::string& name);
    double maximumOf(const std::string& scanner) const;

    mapping::HeightMap map_;
    std::map<std::string, Scanner> scanners_;
    std::map<std::string, double> maximum_m_;
    std::vector<Vec3> last_hits_;
};

} // namespace usar::mission
