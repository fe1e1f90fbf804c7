// Signal strengths between the radios of a simulation, and the bytes that they carry; shared by the wireless server and
// the ComServer.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <QObject>
#include <QString>

#include "core/server/access.h"
#include "core/server/relayed_link.h"
#include "core/sim/simulation.h"

namespace usar::server {

/// The radios by the names that the robots have on the wire. Caches its answers until the world moves, so that many
/// questions are cheap. To be used in the simulator's thread; the simulation must outlive it.
class RadioField {
public:
    explicit RadioField(const sim::Simulation& simulation) : simulation_(simulation) {}

    /// Drops all cached answers. To be called when the world has moved.
    void forget();
    /// First robot or base station with that name; null if there is none or its battery is empty. Valid until forget().
    const sim::RadioStation* station(const std::string& name);
    /// All robots and base stations, including those with an empty battery. Valid until forget().
    const std::vector<sim::RadioStation>& stations();
    /// Signal strength between two stations; nullopt if either is missing or has an empty battery.
    std::optional<double> strength_dbm(const std::string& a, const std::string& b);
    /// Whether the signal between the two is strong enough for a link, that is, at least the radio's `cutoff_dbm`.
    bool reaches(const std::string& a, const std::string& b);

private:
    const sim::Simulation& simulation_;
    std::optional<std::vector<sim::RadioStation>> stations_;
    std::map<std::pair<std::string, std::string>, std::optional<double>> strengths_dbm_;
};

/// Carries bytes between robots while their radios reach each other. A door is a port that one robot calls to reach a
/// port of another. It listens while the two robots reach each other; a link whose strength falls below the cutoff is
/// dropped, and once the strength is back the same door accepts new calls. A robot's program listens on the machine
/// that it registered from. Runs in the simulator's thread; the simulation must outlive it.
class RadioRelay : public QObject {
    Q_OBJECT
public:
    explicit RadioRelay(const sim::Simulation& simulation, QObject* parent = nullptr);
    ~RadioRelay() override;

    RadioField& field() { return field_; }
    /// Admits this machine alone to the doors unless told otherwise before the first one.
    void setAccess(const Access& access) { access_ = access; }
    /// The machine that the robot's program listens on; this one unless told otherwise.
    void setHost(const std::string& robot, const QHostAddress& host);
    /// Port on which `from` reaches port `to_port` of `to`; always the same one for the same arguments. 0 if no more
    /// doors are available.
    quint16 door(const std::string& from, const std::string& to, quint16 to_port);
    /// Name of the robot whose call reaches `to` from this port; empty if there is none.
    std::string callerOf(const std::string& to, quint16 caller_port) const;
    /// Connects to both robots and joins the two connections. False if the robots do not reach each other or too many
    /// links are open.
    bool join(const std::string& from, quint16 from_port, const std::string& to, quint16 to_port);
    /// Closes all doors from and to this robot; links that are open stay open.
    void closeDoorsOf(const std::string& robot);
    std::size_t links() const { return links_.size(); }
    std::size_t doors() const { return doors_.size(); }

public slots:
    /// Adapts links and doors after the world has moved. To be called at each tick.
    void look();

signals:
    /// A sentence about a lost link, for the log.
    void logged(const QString& sentence);

private:
    /// Calling robot, called robot, and the port of the called one.
    using Way = std::tuple<std::string, std::string, quint16>;
    struct Door {
        std::unique_ptr<GuardedServer> server; ///< listens only while the robots reach each other
        quint16 port = 0;                      ///< stays the same while the door is shut
    };
    void takeCalls(const Way& way);
    void add(RelayedLink* link);
    /// Calls a port of the robot's program. The caller owns the socket.
    QTcpSocket* callRobot(const std::string& robot, quint16 port) const;
    void turn(const Way& way, Door& door);

    RadioField field_;
    Access access_;
    std::map<std::string, QHostAddress> hosts_; ///< of robots whose programs are on other machines
    std::map<Way, Door> doors_;
    std::vector<RelayedLink*> links_;
};

} // namespace usar::server
