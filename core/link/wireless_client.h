// Asks a wireless server for the radio signal strengths between robots.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QObject>
#include <QStringList>
#include <QTimer>

#include "core/link/tcp_link.h"

namespace usar::link {

/// Signal strength between two robots, the same both ways; nullopt: the server does not know it.
struct RadioStrength {
    /// Names of the two robots.
    QString a;
    QString b;
    std::optional<double> strength_dbm;
    bool operator==(const RadioStrength&) const = default;
};

using RadioStrengths = std::vector<RadioStrength>;

/// Sends INIT as `MissionControl` (`MissionControl-2` and so on if that name is taken), which is no robot's name, so a
/// robot's own program can still INIT as that robot; our server gives such an observer the strength between any two
/// robots. A server that does not (the original) answers for the asking robot only, and hangs up on names that are not
/// in its world: with such a server, one connection per robot sends INIT as that robot, and if another program has a
/// robot's name, the other robot of each pair asks. INIT gives port 1, because nobody is to call it. Reconnects by
/// itself; runs in its owner's thread.
class WirelessClient : public QObject {
    Q_OBJECT
public:
    WirelessClient();

    /// Applies to connections that are made afterward.
    void setLimits(const LinkLimits& limits) { limits_ = limits; }
    /// Time between two rounds of questions; initially 1 s.
    void setInterval(std::chrono::milliseconds interval) { timer_.setInterval(interval); }
    /// Sets the server. The connection is made once at least two robots are set.
    void open(const QString& host, quint16 port);
    /// Disconnects and reports no strengths.
    void close();
    /// Names of the robots between which strengths are asked for.
    void setRobots(const QStringList& names);

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    /// Emitted after a round of answers, with each pair that the server has answered for, in the order of the names;
    /// empty while nothing is known.
    void reported(const usar::link::RadioStrengths& strengths);

private:
    /// A connection to the server under one name.
    struct Line {
        TcpLink link;
        QString name; ///< name that it gives with INIT
        bool initialized = false;
        bool refused = false; ///< another program already has the name

        bool speaks() const { return initialized && link.status().state == LinkState::Connected; }
        void introduce() { link.send("INIT {Robot " + name.toStdString() + "} {Port 1}"); }
    };
    using Pair = std::pair<QString, QString>;

    /// Drops all connections and, with at least two robots, begins with an observer.
    void restart();
    void openMembers();
    std::unique_ptr<Line> makeLine(const QString& name);
    void take(Line& line, std::string_view text);
    void takeError(Line& line, std::string_view reason);
    void takeStrength(Line& line, std::string_view robot, std::string_view from, std::string_view strength);
    /// Begins a round of questions, one for each pair of robots.
    void ask();
    void askFor(const Pair& pair);
    void report();
    void showStatus();
    /// The connection that asks for this robot, or nullptr.
    Line* speakerOf(const QString& robot);

    QString host_;
    quint16 port_ = 0;
    LinkLimits limits_;
    QTimer timer_{this};
    QStringList robots_;
    std::unique_ptr<Line> observer_;                   ///< for a server that answers an observer
    std::map<QString, std::unique_ptr<Line>> members_; ///< for a server that does not; by robot
    int observer_number_ = 1;
    /// Answers of the current round, in dBm.
    std::map<Pair, std::optional<double>> round_;
    std::size_t awaited_ = 0; ///< answers of this round that are still missing
    LinkStatus status_;
};

} // namespace usar::link
