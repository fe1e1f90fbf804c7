// The ComServer, the older radio server inside the game (protocol.md 6.3): plain words, each request ended by a
// semicolon.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QObject>

#include "core/protocol/usual_values.h"
#include "core/server/radio_relay.h"
#include "core/server/request_server.h"

namespace usar::server {

/// Answers REGISTER, LISTEN, OPEN and GETSS as the original does. Robots listen on ports of their own; OPEN makes the
/// server connect to both robots and join the two connections, on which the robots use SEND and CLOSE. A registered
/// name outlives the connection that registered it, as in the game, where a robot may use a new connection for each
/// request. Registered addresses are kept but not called, because all robots are on this machine. Runs in the
/// simulator's thread; `relay` must outlive it.
class ComServer : public QObject {
    Q_OBJECT
public:
    static constexpr quint16 usual_port = protocol::usual_port::com_server;

    explicit ComServer(RadioRelay& relay, QObject* parent = nullptr);

    /// Loopback only; port 0 chooses a free one. Returns the port. A port in use is an error that names
    /// --comserver-port.
    Result<quint16> listen(quint16 port) { return server_.listen(port, "--comserver-port"); }
    quint16 port() const { return server_.port(); }

private:
    using Words = std::vector<std::string>;
    std::string answer(std::string_view request);
    std::string registerRobot(const Words& words);
    std::string listenFor(const Words& words);
    std::string open(const Words& words);
    std::string strength(const Words& words);
    /// Returns true if there is room for one more name. If the table is full, it removes a name that is not in the
    /// world.
    bool makeRoom();

    RadioRelay& relay_;
    RequestServer server_;
    std::map<std::string, std::string> addresses_;           ///< registered address, by robot
    std::vector<std::pair<std::string, quint16>> listening_; ///< robot and port, one entry per LISTEN
};

} // namespace usar::server
