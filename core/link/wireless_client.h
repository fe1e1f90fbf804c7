// Asks a wireless server how strong the radios of some robots are at each other.
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

/// Between two robots, the same both ways. Nothing: the server cannot say.
struct RadioStrength {
    QString a;
    QString b;
    std::optional<double> strength_dbm;
    bool operator==(const RadioStrength&) const = default;
};

using RadioStrengths = std::vector<RadioStrength>;

/// Says INIT as `MissionControl` (`MissionControl-2` and so on where that name is taken), which is no robot's name, so
/// a robot's own program can still INIT as that robot; our server tells such an observer the strength between any two.
/// A server that does not (the original) answers for the asking robot only, and hangs up on names that are not in its
/// world: there a connection for each robot says INIT as that robot, and a robot whose name another program has is
/// asked for from the other side. It gives port 1 as its own, for nobody is to call it. Reconnects by itself; lives in
/// its owner's thread.
class WirelessClient : public QObject {
    Q_OBJECT
public:
    explicit WirelessClient(QObject* parent = nullptr);
    ~WirelessClient() override;

    void setLimits(const LinkLimits& limits);
    void setInterval(std::chrono::milliseconds interval) { timer_.setInterval(interval); }
    /// Nothing is connected to while fewer than two robots are asked for.
    void open(const QString& host, quint16 port);
    void close();
    void setRobots(const QStringList& names);

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    /// A round of answers: of each pair that the server knows something about, in the order of the names.
    void reported(const usar::link::RadioStrengths& strengths);

private:
    struct Line {
        TcpLink link;
        QString name; ///< as which it says INIT
        bool initialized = false;
        bool refused = false; ///< another program has the name

        void introduce() { link.send("INIT {Robot " + name.toStdString() + "} {Port 1}"); }
    };
    using Pair = std::pair<QString, QString>;

    void restart();
    void openObserver();
    void openMembers();
    std::unique_ptr<Line> makeLine(const QString& name);
    void take(Line& line, std::string_view text);
    void takeError(Line& line, std::string_view reason);
    void takeStrength(Line& line, std::string_view robot, std::string_view from, std::string_view strength);
    void ask();
    void askFor(const Pair& pair);
    void report();
    void showStatus();
    Line* speakerOf(const QString& robot);

    QString host_;
    quint16 port_ = 0;
    LinkLimits limits_;
    QTimer timer_;
    QStringList robots_;
    std::unique_ptr<Line> observer_;                   ///< of a server that answers one
    std::map<QString, std::unique_ptr<Line>> members_; ///< of one that does not, by robot
    int observer_number_ = 1;
    std::map<Pair, std::optional<double>> round_;
    std::size_t awaited_ = 0; ///< answers of this round
    LinkStatus status_;
};

} // namespace usar::link

Q_DECLARE_METATYPE(usar::link::RadioStrengths)
