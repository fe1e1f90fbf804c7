// The wireless simulation server, WSS (usarsim-protocol 6.2): strengths, and ports behind which other robots listen.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>

#include "core/link/radio_relay.h"
#include "core/link/request_server.h"

namespace usar::link {

/// INIT, GETSS, DNS and REVERSEDNS, answered as the original answers, its dotted reasons to the letter. A name belongs
/// to the connection that said INIT, until that closes. Unlike the original it waits for a robot that is not there yet
/// instead of hanging up on it. Beside it, for who only looks on: `GETSS {Robot b} {From a}` is answered with
/// `SS {Robot b} {From a} {Strength s}` for any two in the world, whoever asks. In the simulator's thread.
class WirelessServer : public QObject {
    Q_OBJECT
public:
    static constexpr quint16 usual_port = 50000;

    explicit WirelessServer(RadioRelay& relay, QObject* parent = nullptr);

    Result<quint16> listen(quint16 port) { return server_.listen(port, "--wireless-port"); }
    quint16 port() const { return server_.port(); }
    void setMostClients(std::size_t count) { server_.setMostClients(count); }

private:
    struct Member {
        std::string robot;
        std::vector<quint16> ports; ///< where it listens
    };

    std::string answer(int client, std::string_view line);
    std::string init(int client, std::string_view robot, std::string_view ports);
    std::string strength(const std::string& own, const std::string& other);
    std::string strengthBetween(const std::string& from, const std::string& to);
    std::string door(const std::string& own, const std::string& other, std::string_view port);
    std::string caller(const std::string& own, std::string_view port);
    const Member* member(std::string_view robot) const;
    void leave(int client);

    RadioRelay& relay_;
    RequestServer server_;
    std::map<int, Member> members_; ///< by client
};

} // namespace usar::link
