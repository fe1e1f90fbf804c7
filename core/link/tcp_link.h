// The client's end of one connection to a USARSim server.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTimer>

#include "core/base/clock.h"
#include "core/link/greeting_check.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/traffic_counts.h"

namespace usar::link {

enum class LinkState { Disconnected, Connecting, Connected, Waiting }; ///< Waiting: for the next try

/// What the connection bar shows. `reason` is one or two sentences with the mend, empty while all is well.
struct LinkStatus {
    LinkState state = LinkState::Disconnected;
    QString host;
    quint16 port = 0;
    QString reason;
    QString trouble;       ///< `reason` without "Retrying in 4 s."
    Seconds retry_in{0.0}; ///< while Waiting
    bool operator==(const LinkStatus&) const = default;
};

/// Wall-clock limits. Tests shorten them.
struct LinkLimits {
    Seconds connect_timeout{5.0};
    Seconds first_retry{0.5};
    Seconds longest_retry{10.0};
    std::size_t most_unsent_bytes = 16u << 20; ///< a server that lets more pile up has died; the link tries anew
};

/// Connects, reconnects with back-off until told to close, gives whole lines, and sends lines with CR LF. The back-off
/// starts anew only when the server has said something that looks like USARSim, so a port that accepts and hangs up is
/// not hammered. Never blocks; always reads. Lives in its owner's thread, which has an event loop.
class TcpLink : public QObject {
    Q_OBJECT
public:
    /// The view lives during the call and has no terminator.
    using LineTaker = std::function<void(std::string_view line)>;

    explicit TcpLink(QObject* parent = nullptr);
    ~TcpLink() override;

    void setLimits(const LinkLimits& limits) { limits_ = limits; }
    /// What reasons call the server, and the port that they name as the usual one.
    void setService(const QString& name, quint16 usual_port) {
        service_ = name;
        usual_port_ = usual_port;
    }
    /// Who gets the lines: a plain call, for a signal with a copy is too dear at hundreds of times real time. The taker
    /// may call any function of the link.
    void setLineTaker(LineTaker taker) { take_line_ = std::move(taker); }
    /// Who sees every byte that comes, as each read gave it, before its lines.
    void setByteTaker(std::function<void(std::string_view bytes)> taker) { take_bytes_ = std::move(taker); }
    /// What has come of a line that has not ended.
    std::string_view pending() const { return splitter_.pending(); }

    /// Closes what is open, then connects there.
    void open(const QString& host, quint16 port);
    /// Sends what is queued, closes, and does not reconnect.
    void close();
    /// Queues the line; dropped while there is no connection.
    void send(std::string_view line);
    /// Queued here because the server does not read; what the network holds is not among them.
    std::size_t unsentBytes() const { return static_cast<std::size_t>(socket_.bytesToWrite()); }
    /// Hands what is queued to the network now instead of when the event loop gets to it.
    void flush() { socket_.flush(); }
    const LinkStatus& status() const { return status_; }
    /// Lines longer than the splitter's cap that were dropped, over all connections.
    std::size_t overlongCount() const { return splitter_.overlongCount(); }
    /// Lines, bytes and dropped lines of this connection, or of the last one; what lines say is not counted here.
    protocol::TrafficCounts counts() const;

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    void opened();
    /// After `opened`, when the connection is gone for any reason; not for tries that never connected.
    void closed();

private:
    void connectNow();
    void takeConnection();
    void takeBytes();
    void giveLine(std::string_view line);
    void takeError(QAbstractSocket::SocketError error);
    void failWhereNobodyReads();
    QString place() const;
    QString foreignReason() const;
    QString reasonOf(QAbstractSocket::SocketError error) const;
    void failed(const QString& trouble);
    void dropConnection();
    void setStatus(LinkState state, const QString& trouble = {}, Seconds retry_in = Seconds{0.0});

    QTcpSocket socket_;
    QTimer retry_timer_;
    QTimer connect_timer_;
    LineTaker take_line_;
    std::function<void(std::string_view)> take_bytes_;
    LinkLimits limits_;
    QString service_ = QStringLiteral("USARSim");
    quint16 usual_port_ = 3000;
    protocol::LineSplitter splitter_;
    GreetingCheck greeting_;
    protocol::TrafficCounts counts_;
    std::size_t overlong_before_ = 0; ///< on earlier connections
    LinkStatus status_;
    int failed_tries_ = 0;
    bool wanted_ = false;
};

} // namespace usar::link

Q_DECLARE_METATYPE(usar::link::LinkStatus)
