// A TCP server for short requests and short replies: the common part of the radio servers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>

#include "core/server/access.h"

namespace usar::server {

/// A port number in a request, from 0 to 65535; nullopt if the text is none.
std::optional<quint16> readPort(std::string_view text);

/// Bounded per client: 4 KiB per request (a longer one is dropped up to its end), 16 KiB per turn of the event loop,
/// and nothing is read from a client that does not read its replies. When all places are taken, a client that has not
/// asked anything yet is disconnected to make room; without one, the new client is refused. Runs in its owner's thread.
class RequestServer : public QObject {
    Q_OBJECT
public:
    ~RequestServer() override;

    /// Admits this machine alone unless told otherwise before `listen`.
    void setAccess(const Access& access) { server_.setAccess(access); }
    /// Port 0 chooses a free one. Returns the port. A port in use is an error that names the option with which to
    /// choose another.
    Result<quint16> listen(quint16 port) { return server_.open(port, option_); }
    quint16 port() const { return server_.serverPort(); }
    void setMostClients(std::size_t count) { most_clients_ = count; }

protected:
    /// Each character of `ends` ends a request. `option` is the command line option for the port, for errors.
    RequestServer(std::string ends, std::string option, QObject* parent);
    /// Returns the reply exactly as it is to be sent; may be empty. `request` is trimmed and never empty.
    virtual std::string answer(int client, std::string_view request) = 0;
    /// The machine that a client calls from.
    QHostAddress hostOf(int client) const { return clients_.at(client).socket->peerAddress(); }
    /// Called when a client has disconnected, but not for one that was removed to make room.
    virtual void leave(int /*client*/) {}

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
    const std::string option_;
    GuardedServer server_{this};
    std::map<int, Client> clients_;
    std::size_t most_clients_ = 256;
    int last_client_ = 0;
};

} // namespace usar::server
