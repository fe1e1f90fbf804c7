// Keeps the newest scans until a behavior tells where they were taken, and writes them into the height map.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "core/agent/published.h"
#include "core/mapping/height_map.h"
#include "core/mapping/level_flight.h"
#include "core/mapping/path_correction.h"
#include "core/mapping/scan_integrator.h"
#include "core/mapping/scan_store.h"
#include "core/protocol/command.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// A behavior places a scan in the tick that follows it or soon after, so a few scans per scanner are enough. Strips
/// are joined per scanner. Scanners beyond `scanner_limit` (garbled names) share one entry. Owned by one session.
class ScanMapper {
public:
    static constexpr std::size_t shelf_size = 8;
    static constexpr std::size_t scanner_limit = 16;
    static constexpr std::size_t mount_limit = 64;

    /// `cell_size_m` is the size of the map's cells.
    explicit ScanMapper(double cell_size_m) : map_(cell_size_m) {}

    /// Keeps a scan; `line` is the info line in which it came.
    void takeScan(const protocol::RangeScan& scan, LineNumber line);
    /// Learns the maximum range of scanners from CONF; at and beyond it, a beam hit nothing. It is 20 m until it is
    /// known.
    void takeConfiguration(const protocol::ConfigurationInfo& configuration);
    /// Learns from GEO how scanners are mounted on the robot. Scans are placed as the behavior says until it is known.
    void takeGeometry(const protocol::GeometryInfo& geometry);
    /// Takes the robot's own estimate of its pose, from which the drift of roll and pitch is learned. True if it shows
    /// that the INS was set, as a command had told it.
    bool takePose(const agent::PoseEstimate& estimate);
    /// Takes a command that was sent, because one that sets the INS ends its drift as soon as the estimates agree: to
    /// the rounding of the wire, or, once the server has confirmed it, to the noise that an INS may have at rest.
    void takeSent(const protocol::Command& command);
    /// Takes an answer of the server, which may confirm that the INS was set.
    void takeResponse(const protocol::Response& response);
    /// Learns whether the robot flies by the ground truth. Nothing else is taken from it.
    void takeTruth(const protocol::GroundTruthReading& reading);
    /// Whether placed scans get the roll and pitch of LevelFlight instead of the INS's own, and are kept so that the
    /// map can be made again. They do and are unless this is called; to be called before the first scan.
    void improve(bool on) { improves_ = on; }
    /// Whether placed scans are kept even if nothing is improved; initially they are not.
    void keepScans(bool on) { keeps_ = on; }
    /// Scans are written into the map without this error, until the INS is set; they are kept with it.
    void setError(const mapping::PathKnot& error) { error_ = error; }
    /// Writes a kept scan into the map. False if the scan is not kept, or no longer. Scans that do not follow one
    /// another are not joined.
    bool place(const agent::ScanPlacement& placement);
    /// Forgets all scans, to be called for a new connection, on which old line numbers mean nothing. The map stays.
    void forgetScans();
    /// Empties the map and forgets the scans that it was made of; without `cell_size_m` the size of its cells stays the
    /// same.
    void clearMap(std::optional<double> cell_size_m = {});

    /// Replaces the map by one that was made from the kept scans.
    void replaceMap(mapping::HeightMap map);

    const mapping::ScanStore& store() const { return store_; }
    mapping::HeightMap& map() { return map_; }
    const mapping::HeightMap& map() const { return map_; }
    /// Points hit by the newest placed scan of any scanner, map frame, NaN = no hit.
    const std::vector<Vec3>& lastHits() const { return last_hits_; }

private:
    struct Shelved {
        protocol::RangeScan scan;
        LineNumber line;
        std::uint64_t ordinal = 0; ///< number of the scan on this connection and scanner, from 1; 0: empty
    };
    struct Scanner {
        mapping::ScanIntegrator integrator;
        std::array<Shelved, shelf_size> shelf;
        std::uint64_t scans_taken = 0;
        std::uint64_t last_placed = 0;
        std::uint32_t number = 0; ///< KeptScan::scanner
    };
    Scanner& scannerNamed(const std::string& name);
    /// The scanner's pose without the drift of the INS's roll and pitch.
    Pose leveled(const std::string& scanner, const Pose& scanner_in_map) const;
    /// Maximum range in meters.
    double maximumOf(const std::string& scanner) const;

    mapping::HeightMap map_;
    std::map<std::string, Scanner> scanners_;
    std::map<std::string, double> maximum_m_; ///< by scanner
    std::map<std::string, Pose> mounts_;      ///< poses of scanners in the robot's frame
    std::optional<Vec3> set_in_map_m_;        ///< where the INS was told to be, until it is there
    int estimates_since_set_ = 0;
    bool set_confirmed_ = false;
    std::deque<Vec3> truths_m_; ///< the newest true positions
    bool errs_ = false;         ///< So many estimates in a row were none of them that the robot flies by the INS.
    int unlike_ = 0;            ///< so many so far
    std::optional<Vec3> last_base_in_map_m_;
    mapping::LevelFlight level_flight_;
    mapping::PathKnot error_; ///< The estimate of position and yaw is off by so much now, as far as it is known.
    mapping::ScanStore store_;
    bool improves_ = false;
    bool keeps_ = false;
    std::vector<Vec3> last_hits_;
};

} // namespace usar::mission
