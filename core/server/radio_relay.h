// Carries bytes between robots while their radios reach each other; shared by the wireless server and the ComServer.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <QObject>
#include <QString>
#include <QTcpServer>

#include "core/server/radio_field.h"
#include "core/server/relayed_link.h"

namespace usar::server {

/// A door is a port that one robot calls to reach a port of another. It listens while the two robots reach each other;
/// a link whose strength falls below the cutoff is dropped, and once the strength is back the same door accepts new
/// calls. Robots must listen on this machine; no other host is served. Runs in the simulator's thread; the simulation
/// must outlive it.
class RadioRelay : public QObject {
    Q_OBJECT
public:
    explicit RadioRelay(const sim::Simulation& simulation, QObject* parent = nullptr);
    ~RadioRelay() override;

    RadioField& field() { return field_; }
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
        std::unique_ptr<QTcpServer> server; ///< listens only while the robots reach each other
        quint16 port = 0;                   ///< stays the same while the door is shut
    };
    void takeCalls(const Way& way);
    void add(RelayedLink* link);
    void turn(const Way& way, Door& door);

    RadioField field_;
    std::map<Way, Door> doors_;
    std::vector<RelayedLink*> links_;
};

} // namespace usar::server
