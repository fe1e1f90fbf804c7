// The client end of one connection to a USARSim server.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTimer>

#include "core/base/clock.h"
#include "core/link/greeting_check.h"
#include "core/link/in_process_socket.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/traffic_counts.h"
#include "core/protocol/usual_values.h"

namespace usar::link {

enum class LinkState { Disconnected, Connecting, Connected, Waiting }; ///< Waiting: between two attempts to connect

/// State of a connection, as the connection bar shows it. `reason` is one or two sentences with the remedy, empty while
/// all is well.
struct LinkStatus {
    LinkState state = LinkState::Disconnected;
    QString host;
    quint16 port = 0;
    QString reason;
    QString trouble;       ///< `reason` without "Retrying in 4 s."
    Seconds retry_in{0.0}; ///< while Waiting, else 0
    bool operator==(const LinkStatus&) const = default;
};

/// The server as "host:port".
std::string placeOf(const LinkStatus& status);

/// Wall-clock limits. Tests shorten them.
struct LinkLimits {
    Seconds connect_timeout{5.0};
    Seconds first_retry{0.5};
    Seconds longest_retry{10.0};
    std::size_t most_unsent_bytes = 16u << 20; ///< with more unsent, the server counts as dead, and the link reconnects
};

/// Connects, reconnects with growing pauses until closed, delivers whole lines, and sends lines with CR LF. The pauses
/// start small again only after the server has sent something that looks like USARSim, so a port that accepts and hangs
/// up is not hammered. Never blocks; always reads. Runs in its owner's thread, which needs an event loop.
class TcpLink : public QObject {
    Q_OBJECT
public:
    /// The view is valid during the call; it has no line end.
    using LineTaker = std::function<void(std::string_view line)>;

    explicit TcpLink(QObject* parent = nullptr);
    ~TcpLink() override;

    void setLimits(const LinkLimits& limits) { limits_ = limits; }
    /// Name of the server and its usual port, as they appear in LinkStatus::reason.
    void setService(const QString& name, quint16 usual_port) {
        service_ = name;
        usual_port_ = usual_port;
    }
    /// Sets the receiver of lines. It is a plain call, because a signal with a copy is too expensive at hundreds of
    /// times real time. The taker may call any function of the link.
    void setLineTaker(LineTaker taker) { take_line_ = std::move(taker); }
    /// Sets a receiver of the lines that came together, which are then given one by one, unless the connection ends
    /// before. It is called where there are two and more, and must not call the link.
    void setAheadTaker(std::function<void(std::span<const std::string_view> lines)> taker) {
        take_ahead_ = std::move(taker);
    }
    /// Sets a receiver of all incoming bytes, as each read returned them, before their lines.
    void setByteTaker(std::function<void(std::string_view bytes)> taker) { take_bytes_ = std::move(taker); }
    /// The received part of a line that has not ended.
    std::string_view pending() const { return splitter_.pending(); }

    /// Closes any open connection. From now on `open` connects to this server of the same thread instead of by TCP; its
    /// host and port are only what the status says.
    void useInProcess(InProcessServer server);
    /// Closes any open connection, then connects to this server.
    void open(const QString& host, quint16 port);
    /// Sends what is queued, closes, and does not reconnect.
    void close();
    /// Queues the line, to which CR LF is added; dropped while there is no connection.
    void send(std::string_view line);
    /// Bytes queued here because the server does not read, without what the network holds; in process, all that it has
    /// not read.
    std::size_t unsentBytes() const { return static_cast<std::size_t>(socket_->bytesToWrite()); }
    /// Hands queued bytes to the network now instead of in the event loop's next turn.
    void flush() { socket_->flush(); }
    const LinkStatus& status() const { return status_; }
    /// Number of lines that were dropped because they exceed the splitter's cap, over all connections.
    std::size_t overlongCount() const { return splitter_.overlongCount(); }
    /// The time from here to the server and back, as the system smooths it from the acknowledgments of what was sent
    /// (RFC 6298); absent without a connection, or where the system does not tell. Waits for nothing.
    std::optional<Seconds> roundTrip() const;
    /// Lines, bytes and dropped lines of this connection, or of the last one. Fields about the contents of lines stay
    /// 0.
    protocol::TrafficCounts counts() const;

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    void opened();
    /// Emitted after `opened`, when the connection is gone for any reason; not after attempts that never connected.
    void closed();

private:
    void wire();
    void connectNow();
    void takeConnection();
    void takeBytes();
    void giveLine(std::string_view line);
    void takeError(QAbstractSocket::SocketError error);
    void failWhereNobodyReads();
    QString place() const { return QString::fromStdString(placeOf(status_)); }
    QString foreignReason() const;
    QString reasonOf(QAbstractSocket::SocketError error) const;
    void failed(const QString& trouble);
    void dropConnection();
    void setStatus(LinkState state, const QString& trouble = {}, Seconds retry_in = Seconds{0.0});

    QTcpSocket* socket_ = new QTcpSocket(this);
    QTimer retry_timer_{this};
    QTimer connect_timer_{this};
    LineTaker take_line_;
    std::function<void(std::string_view)> take_bytes_;
    std::function<void(std::span<const std::string_view>)> take_ahead_;
    LinkLimits limits_;
    QString service_ = QStringLiteral("USARSim");
    quint16 usual_port_ = protocol::usual_port::bot;
    protocol::LineSplitter splitter_;
    std::vector<std::string_view> lines_; ///< those of earlier bytes; kept to reuse their memory
    GreetingCheck greeting_;
    protocol::TrafficCounts counts_;
    std::size_t overlong_before_ = 0; ///< overlong lines of earlier connections
    LinkStatus status_;
    int failed_tries_ = 0;
    bool wanted_ = false;
};

} // namespace usar::link
