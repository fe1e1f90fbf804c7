// A loopback TCP server for short requests and short replies: the common part of the radio servers.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>

#include "core/base/result.h"

namespace usar::server {

/// Bounded per client: 4 KiB per request (a longer one is dropped up to its end), 16 KiB per turn of the event loop,
/// and nothing is read from a client that does not read its replies. When all places are taken, a client that has not
/// asked anything yet is disconnected to make room; without one, the new client is refused. Runs in its owner's thread.
class RequestServer : public QObject {
    Q_OBJECT
public:
    /// Returns the reply exactly as it is to be sent; may be empty. `request` is trimmed and never empty.
    using Answer = std::function<std::string(int client, std::string_view request)>;

    /// Each character of `ends` ends a request.
    RequestServer(std::string ends, Answer answer, QObject* parent = nullptr);
    ~RequestServer() override;

    /// Loopback only; port 0 chooses a free one. Returns the port. `option` is the command line option that an error
    /// names as the remedy.
    Result<quint16> listen(quint16 port, const std::string& option);
    quint16 port() const { return server_.serverPort(); }
    /// `gone` is called when a client has disconnected, but not for one that was removed to make room.
    void setGone(std::function<void(int client)> gone) { gone_ = std::move(gone); }
    void setMostClients(std::size_t count) { most_clients_ = count; }
    std::size_t clients() const { return clients_.size(); }

private:
    struct Client {
        QTcpSocket* socket = nullptr;
        std::string pending;   ///< beginning of an unfinished request
        bool dropping = false; ///< skipping an overlong request up to its end
        bool has_asked = false;
        bool due = false; ///< its next turn is queued
    };

    void acceptAll();
    /// Disconnects a client that has not asked anything yet; false if there is none.
    bool makeRoom();
    void serveLater(int client);
    void serve(int client);
    void take(int client, std::string_view bytes);
    void forget(int client);

    const std::string ends_;
    Answer answer_;
    std::function<void(int)> gone_;
    QTcpServer server_;
    std::map<int, Client> clients_;
    std::size_t most_clients_ = 256;
    int last_client_ = 0;
};

} // namespace usar::server
