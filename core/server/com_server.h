// The ComServer, the older radio server inside the game (protocol.md 6.3): plain words, each request ended by a
// semicolon; and the ComServerInterface (protocol.md 6.4), which tells an external wireless server where the radios are
// and how many obstacles stand between them.
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
/// request. Registered addresses are kept but not called: a robot is called on the machine that it registered from.
/// Runs in the simulator's thread; `relay` must outlive it.
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
    int asking_ = 0;                                         ///< the client whose request is being answered
    std::map<std::string, std::string> addresses_;           ///< registered address, by robot
    std::vector<std::pair<std::string, quint16>> listening_; ///< robot and port, one entry per LISTEN
};

/// Answers GETPOS, and GETOBS between two points in the wire frame or between two robots by name (as the original
/// wireless server asks). If GETOBS names a place that cannot be read, the answer is -1 obstacles; other requests get
/// no answer. Runs in the simulator's thread; `simulation` and `field` must outlive it.
class ComInterface : public RequestServer {
    Q_OBJECT
public:
    ComInterface(const sim::Simulation& simulation, RadioField& field, QObject* parent = nullptr);

private:
    std::string answer(int client, std::string_view line) override;
    std::string obstacles(std::string_view from, std::string_view to);
    std::string positions();

    const sim::Simulation& simulation_;
    RadioField& field_;
};

} // namespace usar::server
