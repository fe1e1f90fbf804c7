// Serves a simulation on TCP and paces its time.
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
#include "core/server/access.h"
#include "core/sim/physics/scene.h"
#include "core/sim/simulation.h"

namespace usar::server {

/// Pace of the simulation's clock: stopped, a factor of simulated per real seconds, or as fast as possible.
enum class Pace { Paused, Factor, Fast };

/// Figures of the running simulation for the window.
struct SimulatorFigures {
    Seconds now{0.0};              ///< simulated time
    double real_time_factor = 0.0; ///< over the last second
    int clients = 0;
    Pace pace = Pace::Factor;
    double factor = 1.0; ///< simulated per real second; only with Pace::Factor
    bool operator==(const SimulatorFigures&) const = default;
};

/// Owns a Simulation and the clients' sockets; runs in the simulator's thread. With lockstep clients each tick waits
/// for their STEP, whatever the pace, and no timer delays the tick after the last STEP. Pace::Fast stands still while
/// nobody has a robot. A client that does not read is dropped once 8 MiB wait for it. A client that sends no STEP for
/// ten seconds while others are connected is no longer waited for, and is told so. A single client may take its time:
/// it may be stopped in a debugger.
class SimulatorServer : public QObject {
    Q_OBJECT
public:
    explicit SimulatorServer(std::unique_ptr<sim::Simulation> simulation, QObject* parent = nullptr);
    ~SimulatorServer() override;

    /// Admits this machine alone unless told otherwise before `listen`.
    void setAccess(const Access& access) { server_.setAccess(access); }
    const Access& access() const { return server_.access(); }
    /// Port 0 chooses a free one. Returns the port. A port in use is an error that says how to choose another.
    Result<quint16> listen(quint16 port);
    /// The port that it listens on; 0 before `listen`.
    quint16 port() const { return server_.serverPort(); }
    /// Serves a client that is already connected; owns the socket from now on.
    void accept(QTcpSocket* socket);
    SimulatorFigures figures() const;
    /// For the servers of other channels; in the simulator's thread only.
    sim::Simulation& simulation() { return *simulation_; }
    /// A client is dropped once this many bytes wait for it.
    void setUnreadLimit(qint64 bytes) { unread_limit_bytes_ = bytes; }
    /// Time for which other clients wait for a client's STEP.
    void setLockstepPatience(std::chrono::milliseconds patience) { lockstep_patience_ = patience; }
    /// If on, time stands still with Pace::Factor, too, while nobody has a robot. Then what a robot meets does not
    /// depend on how long its program took to ask for it.
    void setTimeBeginsWithRobots(bool on) { time_begins_with_robots_ = on; }

public slots:
    /// `factor`: simulated per real seconds, used with Pace::Factor; 1 if it is not a positive number.
    void setPace(usar::server::Pace pace, double factor = 1.0);
    /// While paused, makes one tick as soon as the lockstep clients allow it.
    void stepOnce();
    /// `from_now`: the faults' begin is relative to now; otherwise it is a time on the simulation's clock.
    void addFaults(const std::vector<usar::sim::Fault>& faults, bool from_now);
    /// Ends the fault with this number at once; an unknown number has no effect.
    void endFault(int id);
    /// Releases the robots of a snapshot that no client has claimed.
    void letOrphansGo();

signals:
    void ticked();                                                      ///< a message tick has been made
    void figuresChanged(const usar::server::SimulatorFigures& figures); ///< a few times a second
    /// A sentence for the user about clients and robots.
    void logged(const QString& sentence);
    /// A client's object was not created, which is not logged. `reason` is part of a sentence; `name` may be empty.
    void objectRefused(const QString& name, const QString& reason);
    /// Emitted with all faults whenever one is added, begins or ends.
    void faultsChanged(const std::vector<usar::sim::FaultStatus>& faults);
    void robotVanished(const QString& name);   ///< a fault has removed it; its client is told nothing, as in the game
    void robotSilenced(const QString& name);   ///< see sim::Simulation::takeSilenced
    void faultTurned(const QString& sentence); ///< such as "60.0 s: fault begins: wind speed=5"
    void robotsChanged(const std::vector<usar::sim::RobotTruth>& robots); ///< emitted with figuresChanged
    /// Emitted with figuresChanged if an object has come, gone or visibly moved.
    void objectsChanged(const usar::protocol::WorldObjects& objects);
    /// Trace marks left by robots of any client since the last emission; emitted with figuresChanged.
    void marksLeft(const std::vector<usar::sim::TraceMark>& marks);

private:
    /// A pair of simulated and real time, for the real-time factor.
    struct Sample {
        qint64 wall_ms = 0;
        Seconds now{0.0};
    };

    /// Accepts all clients that wait for a connection.
    void acceptAll();
    void readFrom(QTcpSocket* socket, sim::ClientId client);
    void forget(QTcpSocket* socket, sim::ClientId client);
    /// Makes the ticks that are due and possible, and starts the timer for the next one.
    void advance();
    void advanceFast();
    void advanceByClock();
    /// Makes one tick of the simulation.
    void tick();
    void flush();
    void publishLog();
    void publishFaults();
    /// Releases from lockstep the clients that have held up others for too long.
    void watchLockstep();
    void report();

    std::unique_ptr<sim::Simulation> simulation_;
    GuardedServer server_{this};
    std::map<sim::ClientId, QTcpSocket*> sockets_;
    QTimer pace_timer_{this};
    QTimer report_timer_{this};
    QElapsedTimer wall_;
    Pace pace_ = Pace::Factor;
    double factor_ = 1.0;
    bool time_begins_with_robots_ = false;
    qint64 unread_limit_bytes_ = 8 << 20;
    std::chrono::milliseconds lockstep_patience_{10000};
    std::chrono::milliseconds held_up_{0}; ///< how long others have been waiting for a client's STEP
    qint64 last_watch_ms_ = 0;
    /// Calls of `stepOnce` that have not been obeyed yet.
    int steps_asked_ = 0;
    std::uint64_t marks_told_ = 0;
    protocol::WorldObjects objects_told_;
    qint64 last_advance_ms_ = 0;
    Seconds tick_;
    Seconds owed_{0.0}; ///< simulated time that is due at this pace but has not been made
    std::deque<Sample> samples_;
};

} // namespace usar::server
