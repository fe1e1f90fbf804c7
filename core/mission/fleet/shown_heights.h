// The heights that the map shows: those of all robots as one map, or those of the selected robot.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QObject>
#include <QStringList>

#include "core/mapping/height_fusion.h"
#include "core/mission/fleet/fleet.h"
#include "core/mission/fleet/own_thread.h"

namespace usar::mission {

/// Live robots and replays have maps of their own: what is replayed happened at another time, and would count twice
/// beside the robot that it was recorded from.
enum class ScanGroup { Live, Replayed };
inline constexpr std::size_t scan_group_count = 2;

/// Fuses the maps of all robots in a thread of its own; owned by a ShownHeights. What arrives together is fused once.
class FusionWorker : public QObject {
    Q_OBJECT
public:
    using Tiles = std::vector<std::shared_ptr<const mapping::HeightTile>>;

    /// See HeightFusion::take.
    void take(ScanGroup group, ConnectionId robot, double cell_size_m, const Tiles& tiles, bool from_scratch);
    void remove(ScanGroup group, ConnectionId robot);

signals:
    void fused(usar::mission::ScanGroup group, std::shared_ptr<const usar::mapping::HeightChange> change);

private:
    mapping::HeightFusion& of(ScanGroup group) { return fusions_[static_cast<std::size_t>(group)]; }
    /// Fuses as soon as nothing else waits.
    void workSoon();
    void work();

    std::array<mapping::HeightFusion, scan_group_count> fusions_;
    bool waits_ = false;
};

/// Follows the fleet's updates and tells a height layer what to show. With AllRobots these are the fused heights of all
/// live robots; while a replay is selected, those of all replays. Belongs to the GUI thread; only the destructor waits,
/// for the end of the fusing thread. The fleet must outlive this object.
class ShownHeights : public QObject {
    Q_OBJECT
public:
    using Tiles = FusionWorker::Tiles;

    explicit ShownHeights(const Fleet& fleet);

    /// Initially AllRobots.
    void setScope(mapping::HeightScope scope);
    mapping::HeightScope scope() const { return scope_; }
    /// The robot whose heights, or whose group, are shown; 0: none. Selecting the same robot again tells all heights
    /// again.
    void select(RobotId id);
    /// Names of the robots that know the height at this point of the map frame and belong to what is shown, in the
    /// order of their ids.
    QStringList knowing(const Vec2& point_in_map_m) const;
    /// The same robots with what each knows there: the selected one first, the others in the order of their ids.
    std::vector<std::pair<RobotId, mapping::HeightProbe>> sourcesAt(const Vec2& point_in_map_m) const;

signals:
    /// Everything shown before is void; the following heights have cells of this size, in meters.
    void begun(double cell_size_m);
    /// Tiles that are new or have changed, and the range of all heights that are shown; nullopt: there are none.
    void grown(const usar::mission::ShownHeights::Tiles& tiles, const std::optional<usar::mapping::HeightRange>& range);

private:
    /// A fused map as the worker told it last.
    struct Fused {
        double cell_size_m = RobotView{}.cell_size_m;
        mapping::HeightTiles tiles;
        std::optional<mapping::HeightRange> range;
    };
    /// Where the heights of a robot went.
    struct Member {
        ConnectionId connection;
        ScanGroup group = ScanGroup::Live;
    };

    void take(RobotId id, const SessionUpdate& update);
    void takeFused(ScanGroup group, const mapping::HeightChange& change);
    void remove(RobotId id);
    void tellAll();
    const RobotView* viewOf(RobotId id) const;
    const Fused& shownFused() const { return fused_[static_cast<std::size_t>(group_)]; }

    const Fleet& fleet_;
    mapping::HeightScope scope_ = mapping::HeightScope::AllRobots;
    RobotId selected_;
    ScanGroup group_ = ScanGroup::Live; ///< of the selected robot
    double told_cell_size_m_ = 0.0;     ///< as `begun` said it last
    std::array<Fused, scan_group_count> fused_;
    std::map<RobotId, Member> members_; ///< robots that have scanned something
    OwnThread<FusionWorker> worker_{"fusion"};
};

} // namespace usar::mission
