#include "core/server/wireless_server.h"

#include <algorithm>
#include <optional>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/segments.h"

namespace usar::server {

namespace {

std::string error(std::string_view reason) {
    return "ERROR {Reason " + std::string(reason) + "}";
}

/// Reads a list such as "5000, 5001"; an empty one is valid, because a robot may only call.
std::optional<std::vector<quint16>> readPorts(std::string_view text) {
    std::vector<quint16> ports;
    while (!trimmed(text).empty()) {
        const std::size_t comma = text.find(',');
        const auto port = readPort(text.substr(0, comma));
        if (!port)
            return std::nullopt;
        ports.push_back(*port);
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    return ports;
}

} // namespace

WirelessServer::WirelessServer(RadioRelay& relay, QObject* parent)
    : RequestServer("\r\n", "--wireless-port", parent)
    , relay_(relay) {}

std::string WirelessServer::answer(int client, std::string_view line) {
    return reply(client, line) + "\r\n";
}

std::string WirelessServer::reply(int client, std::string_view line) {
    Diagnostics diagnostics;
    protocol::Segments segments;
    segments.read(line, diagnostics);
    const std::string_view word = segments.typeWord();
    const std::string robot(segments.value("Robot"));
    const auto own = members_.find(client);
    if (own == members_.end())
        return sameWord(word, "INIT") ? init(client, robot, segments.value("Port"))
                                      : error("Must.Use.INIT.Method.First");
    if (sameWord(word, "REVERSEDNS"))
        return caller(own->second.robot, segments.value("Port"));
    const bool asks_strength = sameWord(word, "GETSS");
    if (!asks_strength && !sameWord(word, "DNS"))
        return error("Method.Unknown.Or.Can.INIT.only.once");
    if (!asks_strength && segments.find("Port") && !readPort(segments.value("Port")))
        return error("Port.Must.Be.Integer");
    if (robot.empty())
        return error("Robot.Name.Must.Not.Be.Empty");
    if (!asks_strength)
        return door(own->second.robot, robot, segments.value("Port"));
    return strength(own->second.robot, std::string(segments.value("From")), robot);
}

std::string WirelessServer::init(int client, std::string_view robot, std::string_view ports_text) {
    const auto ports = readPorts(ports_text);
    if (!ports)
        return error("Ports.List.Must.Be.Integer");
    if (robot.empty())
        return error("Robot.Name.Must.Not.Be.Empty");
    if (member(robot))
        return error("Robot.Alread.Exists"); // Spelled like this by every server.
    members_[client] = {std::string(robot), *ports};
    relay_.setHost(std::string(robot), hostOf(client));
    return "INITREPLY {Status OK}";
}

std::string WirelessServer::strength(const std::string& own, const std::string& from, const std::string& to) {
    const bool of_observer = !from.empty();
    const std::string head = "SS {Robot " + to + (of_observer ? "} {From " + from : "") + "} {Strength ";
    const std::string& other_end = of_observer ? from : own;
    if (to == other_end)
        return head + "INF} {Error SS.To.Self}";
    if (!of_observer && !member(to))
        return head + "NaN} {Error Robot.Does.Not.Exist}";
    if (const auto strength_dbm = relay_.field().strength_dbm(other_end, to))
        return head + fixed(*strength_dbm, 4) + "}";
    return head + "NaN} {Error " + (of_observer ? "Robot.Does.Not.Exist}" : "Model.Returned.NaN}");
}

std::string WirelessServer::door(const std::string& own, const std::string& other, std::string_view port) {
    const std::string head = "DNSREPLY {Robot " + other + "} {Port ";
    const Member* const called = member(other);
    if (!called || other == own)
        return head + "-1} {Error NoSuchRobot}";
    const quint16 wanted = readPort(port).value_or(0);
    const bool any = wanted == 0; // Nobody listens on port 0.
    if (any ? called->ports.empty() : !std::ranges::count(called->ports, wanted))
        return head + "-1} {Error RobotDoesNotListenOnThisPort}";
    const quint16 door = relay_.door(own, other, any ? called->ports.front() : wanted);
    return door == 0 ? error("Could.Not.Allocate.Port") : head + std::to_string(door) + "}";
}

std::string WirelessServer::caller(const std::string& own, std::string_view port_text) {
    const auto port = readPort(port_text);
    if (!port)
        return error("Port.Must.Be.Integer");
    const std::string head = "REVERSEDNSREPLY {Port " + std::to_string(*port) + "} {";
    const std::string from = relay_.callerOf(own, *port);
    return from.empty() ? head + "Error UnknownOrIllegalPort}" : head + "Robot " + from + "}";
}

const WirelessServer::Member* WirelessServer::member(std::string_view robot) const {
    const auto found = std::ranges::find_if(members_, [&](const auto& one) { return one.second.robot == robot; });
    return found == members_.end() ? nullptr : &found->second;
}

void WirelessServer::leave(int client) {
    const auto own = members_.find(client);
    if (own == members_.end())
        return;
    relay_.closeDoorsOf(own->second.robot);
    members_.erase(own);
}

} // namespace usar::server
