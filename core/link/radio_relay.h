// Carries bytes between robots while their radios reach each other: what the wireless server and the ComServer share.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <QObject>
#include <QString>
#include <QTcpServer>

#include "core/link/radio_field.h"
#include "core/link/relayed_link.h"

namespace usar::link {

/// A door is a port for one robot's calls to a port of another. It listens while the two reach each other; a link whose
/// strength falls below the cut-off is dropped, and when the strength is back the same door takes new calls. Robots
/// listen on this machine, for nothing else is served. In the simulator's thread; the simulation must outlive it.
class RadioRelay : public QObject {
    Q_OBJECT
public:
    explicit RadioRelay(const sim::Simulation& simulation, QObject* parent = nullptr);
    ~RadioRelay() override;

    RadioField& field() { return field_; }
    /// The port behind which `to` listens on `to_port`, for `from`; the same for the same three. 0 where all are taken.
    quint16 door(const std::string& from, const std::string& to, quint16 to_port);
    /// Who calls `to` from this port; empty where nobody does.
    std::string callerOf(const std::string& to, quint16 caller_port) const;
    /// Calls both robots and joins the calls. False where they do not reach each other or too many links are open.
    bool join(const std::string& from, quint16 from_port, const std::string& to, quint16 to_port);
    /// Its doors close; links that are open go on.
    void closeDoorsOf(const std::string& robot);
    std::size_t links() const { return links_.size(); }
    std::size_t doors() const { return doors_.size(); }

public slots:
    /// The world has moved: links and doors follow. To be called at each tick.
    void look();

signals:
    void logged(const QString& sentence);

private:
    using Way = std::tuple<std::string, std::string, quint16>;
    struct Door {
        std::unique_ptr<QTcpServer> server;
        quint16 port = 0;
    };
    void takeCalls(const Way& way);
    void add(RelayedLink* link);
    void turn(const Way& way, Door& door);

    RadioField field_;
    std::map<Way, Door> doors_;
    std::vector<RelayedLink*> links_;
};

} // namespace usar::link
