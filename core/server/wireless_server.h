// The wireless simulation server, WSS (protocol.md 6.2): reports signal strengths, and ports through which other
// robots are reached.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/server/radio_relay.h"
#include "core/server/request_server.h"

namespace usar::server {

/// Answers INIT, GETSS, DNS and REVERSEDNS as the original does, with its dotted reasons to the letter. A name belongs
/// to the connection that sent INIT until that closes. Unlike the original it waits for a robot that is not there yet
/// instead of hanging up. In addition, for observers, `GETSS {Robot b} {From a}` is answered with `SS {Robot b} {From
/// a} {Strength s}` for any two robots in the world, whoever asks. Runs in the simulator's thread; `relay` must outlive
/// it.
class WirelessServer : public RequestServer {
    Q_OBJECT
public:
    explicit WirelessServer(RadioRelay& relay, QObject* parent = nullptr);

private:
    /// A connection that has sent INIT.
    struct Member {
        std::string robot;
        std::vector<quint16> ports; ///< on which the robot listens
    };

    std::string answer(int client, std::string_view line) override;
    /// The reply without its line end.
    std::string reply(int client, std::string_view line);
    std::string init(int client, std::string_view robot, std::string_view ports);
    /// Between two robots of the world; `from` is empty if the robot that asks, `own`, is one of them.
    std::string strength(const std::string& own, const std::string& from, const std::string& to);
    std::string door(const std::string& own, const std::string& other, std::string_view port);
    std::string caller(const std::string& own, std::string_view port);
    const Member* member(std::string_view robot) const;
    void leave(int client) override;

    RadioRelay& relay_;
    std::map<int, Member> members_; ///< by client id
};

} // namespace usar::server
