#include "core/server/com_server.h"

#include <algorithm>
#include <optional>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/protocol/segments.h"
#include "core/protocol/wire_frame.h"

namespace usar::server {

namespace {

constexpr std::size_t most_names = 256;

std::string fail(const std::string& reason) {
    return "Fail: " + reason + ";";
}

/// Reads "1,2,3" (meters in the wire frame) as a point in the map frame; nullopt if it is malformed or not finite.
std::optional<Vec3> readPoint(std::string_view text) {
    Vec3 point = Vec3::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const std::size_t comma = text.find(',');
        const auto number = readNumber(text.substr(0, comma));
        if (!number || (i < 2) != (comma != std::string_view::npos))
            return std::nullopt;
        point[i] = *number;
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    if (!point.allFinite())
        return std::nullopt;
    return protocol::acrossWire(point);
}

std::string writePoint(const Vec3& point_in_map_m) {
    const Vec3 point = protocol::acrossWire(point_in_map_m).array() + 0.0; // Makes no 0.00 of the map a -0.00.
    return fixed(point.x(), 2) + "," + fixed(point.y(), 2) + "," + fixed(point.z(), 2);
}

} // namespace

ComServer::ComServer(RadioRelay& relay, QObject* parent)
    : RequestServer(";", "--comserver-port", parent)
    , relay_(relay) {}

std::string ComServer::answer(int client, std::string_view request) {
    asking_ = client;
    Words words;
    for (std::string_view word = takeWord(request); !word.empty(); word = takeWord(request))
        words.emplace_back(word);
    struct Method {
        const char* word;
        std::size_t words;
        std::string (ComServer::*answer)(const Words&);
    };
    static constexpr Method methods[] = {{"REGISTER", 3, &ComServer::registerRobot},
                                         {"LISTEN", 3, &ComServer::listenFor},
                                         {"OPEN", 5, &ComServer::open},
                                         {"GETSS", 3, &ComServer::strength}};
    for (const Method& method : methods)
        if (sameWord(words.front(), method.word))
            return words.size() == method.words ? (this->*method.answer)(words) : fail("Incorrect Message");
    return fail("Unknown message"); // SEND and CLOSE belong on a data link.
}

std::string ComServer::registerRobot(const Words& words) {
    const auto known = addresses_.find(words[1]);
    if (known != addresses_.end() && known->second != words[2])
        return fail("Robot with name " + words[1] + " already registered");
    if (known == addresses_.end() && !makeRoom())
        return fail("Too many robots registered");
    addresses_[words[1]] = words[2];
    relay_.setHost(words[1], hostOf(asking_));
    return "OK;";
}

bool ComServer::makeRoom() {
    if (addresses_.size() < most_names)
        return true;
    const auto absent = std::ranges::find_if(
        addresses_, [this](const auto& one) { return relay_.field().station(one.first) == nullptr; });
    if (absent == addresses_.end())
        return false;
    std::erase_if(listening_, [&](const auto& one) { return one.first == absent->first; });
    addresses_.erase(absent);
    return true;
}

std::string ComServer::listenFor(const Words& words) {
    const std::string& robot = words[1];
    if (!addresses_.contains(robot))
        return fail("Robot " + robot + " not registered");
    const auto port = readPort(words[2]);
    if (!port || *port == 0)
        return fail("Incorrect Message");
    if (std::ranges::count(listening_, std::pair{robot, *port}))
        return fail("Robot with name " + robot + " already listening at port " + words[2]);
    if (std::ranges::count(listening_, robot, [](const auto& one) { return one.first; }) >= 64)
        return fail("Robot with name " + robot + " listens at too many ports");
    listening_.emplace_back(robot, *port);
    return "OK;";
}

std::string ComServer::open(const Words& words) {
    const std::string& from = words[1];
    const std::string& to = words[3];
    const auto from_port = readPort(words[2]);
    const auto to_port = readPort(words[4]);
    const auto listener = to_port ? std::ranges::find(listening_, std::pair{to, *to_port}) : listening_.end();
    if (listener == listening_.end())
        return fail(to + " not listening on port " + words[4]);
    if (!from_port || *from_port == 0)
        return fail("Incorrect Message");
    if (!relay_.field().reaches(from, to))
        return fail("Cannot connect to " + to);
    if (!relay_.join(from, *from_port, to, *to_port))
        return fail("Could not establish connection");
    listening_.erase(listener); // One LISTEN allows one link.
    return "OK;";
}

std::string ComServer::strength(const Words& words) {
    if (!addresses_.contains(words[1]) && !addresses_.contains(words[2]))
        return fail("Server does not accept third party requests");
    const auto strength_dbm = relay_.field().strength_dbm(words[1], words[2]);
    return strength_dbm ? "OK:" + fixed(*strength_dbm, 2) + ";" : fail("Could not calculate signal strength");
}

ComInterface::ComInterface(const sim::Simulation& simulation, RadioField& field, QObject* parent)
    : RequestServer("\r\n", "--cominterface-port", parent)
    , simulation_(simulation)
    , field_(field) {}

std::string ComInterface::answer(int, std::string_view line) {
    Diagnostics diagnostics;
    protocol::Segments segments;
    segments.read(line, diagnostics);
    if (sameWord(segments.typeWord(), "GETPOS"))
        return positions();
    if (!sameWord(segments.typeWord(), "GETOBS"))
        return {};
    return segments.find("From") ? obstacles(segments.value("From"), segments.value("To"))
                                 : obstacles(segments.value("Start"), segments.value("End"));
}

std::string ComInterface::obstacles(std::string_view from, std::string_view to) {
    const auto placeOf = [this](std::string_view text) {
        auto point = readPoint(text);
        if (const sim::RadioStation* const radio = point ? nullptr : field_.station(std::string(text)))
            point = radio->antenna_in_map_m;
        return point;
    };
    const auto from_m = placeOf(from);
    const auto to_m = placeOf(to);
    const int count = from_m && to_m ? simulation_.obstaclesBetween(*from_m, *to_m) : -1;
    return "NUMOBS {From " + std::string(from) + "} {To " + std::string(to) + "} {ObstCount " + std::to_string(count) +
           "}\r\n";
}

std::string ComInterface::positions() {
    const auto& radios = field_.stations();
    const Vec3 up_m(0.0, 0.0, simulation_.options().radio.antenna_height_m);
    std::string line = "POSITIONS {Robots " + std::to_string(radios.size()) + "}";
    for (const sim::RadioStation& radio : radios)
        line += " {Name " + radio.name + " Location " + writePoint(radio.antenna_in_map_m - up_m) + " BatteryEmpty " +
                (radio.silent ? "True" : "False") + "}";
    return line + "\r\n";
}

} // namespace usar::server
