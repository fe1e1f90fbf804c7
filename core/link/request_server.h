// A loopback TCP server of short requests and short replies: the common part of the radio's servers.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>

#include "core/base/result.h"

namespace usar::link {

/// Bounded for each client: 4 KiB a request (a longer one is dropped to its end), 16 KiB a turn of the event loop, and
/// nothing is read from one that does not read its replies. When all places are taken, one who has asked nothing yet
/// makes room. Lives in its owner's thread.
class RequestServer : public QObject {
    Q_OBJECT
public:
    /// The reply as it is sent; may be empty.
    using Answer = std::function<std::string(int client, std::string_view request)>;

    /// Each of `ends` ends a request.
    RequestServer(std::string ends, Answer answer, QObject* parent = nullptr);
    ~RequestServer() override;

    /// Loopback only; port 0 chooses a free one. `option` is what the mend of an error names.
    Result<quint16> listen(quint16 port, const std::string& option);
    quint16 port() const { return server_.serverPort(); }
    void setGone(std::function<void(int client)> gone) { gone_ = std::move(gone); }
    void setMostClients(std::size_t count) { most_clients_ = count; }
    std::size_t clients() const { return clients_.size(); }

private:
    struct Client {
        QTcpSocket* socket = nullptr;
        std::string pending;
        bool dropping = false; ///< an overlong request, up to its end
        bool has_asked = false;
        bool due = false; ///< its turn is posted
    };

    void acceptAll();
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

} // namespace usar::link
