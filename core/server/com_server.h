// The ComServer, the older radio server inside the game (protocol.md 6.3): plain words, each request ended by a
// semicolon.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/server/radio_relay.h"
#include "core/server/request_server.h"

namespace usar::server {

/// Answers REGISTER, LISTEN, OPEN and GETSS as the original does. Robots listen on ports of their own; OPEN makes the
/// server connect to both robots and join the two connections, on which the robots use SEND and CLOSE. A registered
/// name outlives the connection that registered it, as in the game, where a robot may use a new connection for each
/// request. Registered addresses are kept but not called, because all robots are on this machine. Runs in the
/// simulator's thread; `relay` must outlive it.
class ComServer : public RequestServer {
    Q_OBJECT
public:
    explicit ComServer(RadioRelay& relay, QObject* parent = nullptr);

private:
    using Words = std::vector<std::string>;
    std::string answer(int client, std::string_view request) override;
    std::string registerRobot(const Words& words);
    std::string listenFor(const Words& words);
    std::string open(const Words& words);
    std::string strength(const Words& words);
    /// Returns true if there is room for one more name. If the table is full, it removes a name that is not in the
    /// world.
    bool makeRoom();

    RadioRelay& relay_;
    std::map<std::string, std::string> addresses_;           ///< registered address, by robot
    std::vector<std::pair<std::string, quint16>> listening_; ///< robot and port, one entry per LISTEN
};

} // namespace usar::server
