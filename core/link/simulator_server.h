// Serves a simulation on loopback TCP and paces its time.
#pragma once

#include <map>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTcpServer>
#include <QTimer>

#include "core/base/result.h"
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
/// STEP, whatever the pace. A client that does not read is dropped once 8 MiB wait for it.
class SimulatorServer : public QObject {
    Q_OBJECT
public:
    explicit SimulatorServer(std::unique_ptr<sim::Simulation> simulation, QObject* parent = nullptr);
    ~SimulatorServer() override;

    /// Loopback only. Port 0 chooses a free one. A port in use is an error that says how to choose another.
    Result<quint16> listen(quint16 port);
    quint16 port() const { return server_.serverPort(); }

public slots:
    void setPace(usar::link::Pace pace, double factor = 1.0);
    /// While paused: one tick.
    void stepOnce();

signals:
    void figuresChanged(const usar::link::SimulatorFigures& figures); ///< a few times a second
    void logged(const QString& sentence);
    void robotsChanged(const std::vector<usar::sim::RobotTruth>& robots); ///< with figuresChanged

private:
    void acceptAll();
    void readFrom(QTcpSocket* socket, sim::ClientId client);
    void advance();
    void tick();
    void flush();
    void report();

    std::unique_ptr<sim::Simulation> simulation_;
    QTcpServer server_;
    std::map<sim::ClientId, QTcpSocket*> sockets_;
    QTimer pace_timer_;
    QTimer report_timer_;
    QElapsedTimer wall_;
    Pace pace_ = Pace::Factor;
    double factor_ = 1.0;
    Seconds owed_{0.0};
    Seconds last_reported_{0.0};
};

} // namespace usar::link

Q_DECLARE_METATYPE(usar::link::SimulatorFigures)
