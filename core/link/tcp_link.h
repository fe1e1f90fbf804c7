// The client's end of one connection to a USARSim server.
#pragma once

#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTimer>

#include "core/base/clock.h"
#include "core/protocol/line_splitter.h"

namespace usar::link {

enum class LinkState { Disconnected, Connecting, Connected, Waiting }; ///< Waiting: for the next try

/// What the connection bar shows. `reason` is a sentence with the mend, empty while all is well.
struct LinkStatus {
    LinkState state = LinkState::Disconnected;
    QString host;
    quint16 port = 0;
    QString reason;
    Seconds retry_in{0.0}; ///< while Waiting
    bool operator==(const LinkStatus&) const = default;
};

/// Connects, reconnects with back-off (0.5 s doubling to 10 s) until told to close, gives whole lines, and sends lines
/// with CR LF. Never blocks. Lives in its owner's thread, which has an event loop.
class TcpLink : public QObject {
    Q_OBJECT
public:
    explicit TcpLink(QObject* parent = nullptr);

    void open(const QString& host, quint16 port);
    /// Sends what is queued, closes, and does not reconnect.
    void close();
    void send(const std::string& line);
    const LinkStatus& status() const { return status_; }
    /// Lines longer than the splitter's cap that were dropped.
    std::size_t overlongCount() const { return splitter_.overlongCount(); }

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    /// Emitted for each line; the text is without its terminator.
    void lineReceived(const std::string& line);
    void opened();
    void closed();

private:
    void connectNow();
    void failed(const QString& reason);
    void setStatus(LinkState state, const QString& reason = {}, Seconds retry_in = Seconds{0.0});

    QTcpSocket socket_;
    QTimer retry_timer_;
    protocol::LineSplitter splitter_;
    LinkStatus status_;
    int failed_tries_ = 0;
    bool wanted_ = false;
};

} // namespace usar::link

Q_DECLARE_METATYPE(usar::link::LinkStatus)
