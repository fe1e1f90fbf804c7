#include "core/server/com_server.h"

#include <algorithm>
#include <optional>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::server {

namespace {

constexpr std::size_t most_names = 256;
constexpr int strength_decimals = 2;

std::string fail(const std::string& reason) {
    return "Fail: " + reason + ";";
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
        words.emplace_back(word);
    return words;
}

std::optional<quint16> readPort(const std::string& text) {
    const auto port = readInteger(text);
    if (!port || *port < 1 || *port > 65535)
        return std::nullopt;
    return static_cast<quint16>(*port);
}

} // namespace

ComServer::ComServer(RadioRelay& relay, QObject* parent)
    : RequestServer(";", "--comserver-port", parent)
    , relay_(relay) {}

std::string ComServer::answer(int, std::string_view request) {
    const Words words = wordsOf(request);
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
    if (!port)
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
    if (!from_port)
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
    return strength_dbm ? "OK:" + fixed(*strength_dbm, strength_decimals) + ";"
                        : fail("Could not calculate signal strength");
}

} // namespace usar::server
