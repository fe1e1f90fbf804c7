// The ComServer, the older radio inside the game (usarsim-protocol 6.3): plain words that end with a semicolon.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QObject>

#include "core/link/radio_relay.h"
#include "core/link/request_server.h"

namespace usar::link {

/// REGISTER, LISTEN, OPEN and GETSS, answered as the original answers. Robots listen themselves, and OPEN has the
/// server call both; on those calls they say SEND and CLOSE. Names outlive the connection that registered them, as in
/// the game, where a robot may ask on a new one each time. Addresses are kept but not called: all robots are on this
/// machine. In the simulator's thread.
class ComServer : public QObject {
    Q_OBJECT
public:
    static constexpr quint16 usual_port = 5874;

    explicit ComServer(RadioRelay& relay, QObject* parent = nullptr);

    Result<quint16> listen(quint16 port) { return server_.listen(port, "--comserver-port"); }
    quint16 port() const { return server_.port(); }

private:
    using Words = std::vector<std::string>;
    std::string answer(std::string_view request);
    std::string registerRobot(const Words& words);
    std::string listenFor(const Words& words);
    std::string open(const Words& words);
    std::string strength(const Words& words);
    /// Whether there is room for one more name: those that are not in the world go first.
    bool makeRoom();

    RadioRelay& relay_;
    RequestServer server_;
    std::map<std::string, std::string> addresses_; ///< by robot
    std::vector<std::pair<std::string, quint16>> listening_;
};

} // namespace usar::link
