// Serves a simulation on loopback TCP and paces its time.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include "core/base/result.h"
#include "core/sim/scene.h"
#include "core/sim/simulation.h"

namespace usar::link {

/// How the simulation's clock runs. `factor` is simulated per real second; Fast means as quickly as it can.
enum class Pace { Paused, Factor, Fast };

struct SimulatorFigures {
    Seconds now{0.0};
    double real_time_factor = 0.0; ///< over the last second
    int clients = 0;
    Pace pace = Pace::Factor;
    double factor = 1.0;
    bool operator==(const SimulatorFigures&) const = default;
};

/// Owns a Simulation and the sockets; lives in the simulator's thread. With lockstep clients each tick waits for their
/// STEP, whatever the pace, and no timer stands between the last STEP and the tick. Fast stands still while nobody has
/// a robot. A client that does not read is dropped once 8 MiB wait for it; one that says no STEP for ten seconds while
/// others are connected is not waited for any more, and told so. Alone it may take its time: somebody debugs it.
class SimulatorServer : public QObject {
    Q_OBJECT
public:
    explicit SimulatorServer(std::unique_ptr<sim::Simulation> simulation, QObject* parent = nullptr);
    ~SimulatorServer() override;

    /// Loopback only. Port 0 chooses a free one. A port in use is an error that says how to choose another.
    Result<quint16> listen(quint16 port);
    quint16 port() const { return server_.serverPort(); }
    SimulatorFigures figures() const;
    /// For the servers of other channels beside this one; in the simulator's thread only.
    sim::Simulation& simulation() { return *simulation_; }
    void setUnreadLimit(qint64 bytes) { unread_limit_bytes_ = bytes; }
    void setLockstepPatience(std::chrono::milliseconds patience) { lockstep_patience_ = patience; }
    /// Time at a factor stands still, too, while nobody has a robot: then what a robot meets does not depend on how
    /// long its program took to ask for it.
    void setTimeBeginsWithRobots(bool on) { time_begins_with_robots_ = on; }

public slots:
    void setPace(usar::link::Pace pace, double factor = 1.0);
    /// While paused: one tick, as soon as the lockstep clients allow it.
    void stepOnce();
    /// With times from now on where `from_now`; else on the simulation's clock.
    void addFaults(const std::vector<usar::sim::Fault>& faults, bool from_now);
    void endFault(int id);
    /// Robots of a snapshot that nobody has come for.
    void letOrphansGo();

signals:
    void ticked();                                                    ///< a message tick has been made
    void figuresChanged(const usar::link::SimulatorFigures& figures); ///< a few times a second
    void logged(const QString& sentence);
    /// All faults, whenever one is added, begins or ends.
    void faultsChanged(const std::vector<usar::sim::FaultStatus>& faults);
    void faultTurned(const QString& sentence);                            ///< "60.0 s: fault begins: wind speed=5"
    void robotsChanged(const std::vector<usar::sim::RobotTruth>& robots); ///< with figuresChanged
    /// Left behind by robots of any client since the last time; with figuresChanged.
    void marksLeft(const std::vector<usar::sim::TraceMark>& marks);

private:
    /// Simulated time at a moment of real time, for the real-time factor.
    struct Sample {
        qint64 wall_ms = 0;
        Seconds now{0.0};
    };

    void acceptAll();
    void readFrom(QTcpSocket* socket, sim::ClientId client);
    void forget(QTcpSocket* socket, sim::ClientId client);
    /// Makes the ticks that are due and possible, and arms the timer for the next one.
    void advance();
    void advanceFast();
    void advanceByClock();
    void arm(int milliseconds);
    void tick();
    void flush();
    void publishLog();
    void publishFaults();
    void watchLockstep();
    void report();

    std::unique_ptr<sim::Simulation> simulation_;
    QTcpServer server_;
    std::map<sim::ClientId, QTcpSocket*> sockets_;
    QTimer pace_timer_;
    QTimer report_timer_;
    QElapsedTimer wall_;
    Pace pace_ = Pace::Factor;
    double factor_ = 1.0;
    bool time_begins_with_robots_ = false;
    qint64 unread_limit_bytes_ = 8 << 20;
    std::chrono::milliseconds lockstep_patience_{10000};
    std::chrono::milliseconds held_up_{0}; ///< so long others have waited for the STEP of a client
    qint64 last_watch_ms_ = 0;
    int steps_asked_ = 0;
    std::uint64_t marks_told_ = 0;
    qint64 last_advance_ms_ = 0;
    Seconds tick_;
    Seconds owed_{0.0}; ///< simulated time that the pace would have let pass and that was not made
    std::deque<Sample> samples_;
};

} // namespace usar::link

Q_DECLARE_METATYPE(usar::link::SimulatorFigures)
