// One robot from connect to close: the agent life cycle of the thesis (3), the same in the window and headless.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include "core/agent/behavior_host.h"
#include "core/link/tcp_link.h"
#include "core/mapping/height_map.h"
#include "core/mapping/scan_integrator.h"
#include "core/mission/scan_record.h"
#include "core/modules/robot_modules.h"
#include "core/protocol/reader.h"

namespace usar::mission {

struct SpawnRequest {
    std::string class_name = "USARBot.AirRobot";
    std::string robot_name = "R1";
    Pose start_in_map;
};

/// Running figures of a session, coalesced to the frame rate.
struct SessionFigures {
    Seconds now{0.0}; ///< protocol clock
    std::uint64_t lines_received = 0;
    std::uint64_t lines_malformed = 0;
    double lines_per_second = 0.0; ///< of wall time
    bool spawned = false;
    bool behavior_running = false;
};

/// Everything that changed since the last frame, by value.
struct SessionUpdate {
    std::vector<protocol::InfoLine> lines; ///< the newest ones when more than 1000 came in a frame
    std::vector<agent::CausedCommand> commands;
    std::vector<agent::Published> published;
    std::vector<std::shared_ptr<const mapping::HeightTile>> tiles;
    std::optional<mapping::HeightRange> height_range;
    std::vector<Vec3> last_hits; ///< of the newest placed scan, map frame, NaN = no hit
    SessionFigures figures;
};

/// A sentence for the person, with how bad it is.
struct Notice {
    Severity severity = Severity::Note;
    std::string text;
};

/// Link, reader, modules, behavior, height map. Lives in a session thread; all slots are called by queued connection
/// or from that thread; results leave by value in signals. After connect it asks for start poses; INIT is sent once per
/// connection; silence for 5 s of wall time after INIT is a failed spawn; after a reconnect the robot is spawned anew
/// only by request. Stop, close and a finished behavior send the behavior's safe command first.
class RobotSession : public QObject {
    Q_OBJECT
public:
    explicit RobotSession(double cell_size_m = 0.25, QObject* parent = nullptr);
    ~RobotSession() override;

    /// For the headless twin, which runs in the same thread.
    const ScanRecord& record() const { return record_; }
    const SessionFigures& figures() const { return figures_; }

public slots:
    void open(const QString& host, quint16 port, bool lockstep);
    void close();
    void spawn(const usar::mission::SpawnRequest& request);
    void startBehavior(std::shared_ptr<usar::agent::BehaviorHost> host, const usar::agent::Task& task);
    void order(usar::agent::Order order);
    void setParameters(const usar::agent::ParameterSet& parameters);
    /// Safe command at once; the behavior ends as stopped by the person.
    void stop();
    void sendCommand(const usar::protocol::Command& command, const std::string& source);
    /// Hands out a copy of all that was scanned, for the export pool.
    void requestRecord();

signals:
    void linkChanged(const usar::link::LinkStatus& status);
    void startPosesKnown(const usar::protocol::StartPoses& poses, const QString& level);
    void spawned(const QString& robot_name);
    void behaviorFinished(bool success, const QString& reason);
    void updated(std::shared_ptr<const usar::mission::SessionUpdate> update);
    void recordReady(std::shared_ptr<const usar::mission::ScanRecord> record);
    void noticed(const usar::mission::Notice& notice);

private:
    struct Private;
    std::unique_ptr<Private> d_;
    ScanRecord record_;
    SessionFigures figures_;
};

} // namespace usar::mission
