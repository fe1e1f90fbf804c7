#include "core/server/radio_relay.h"

#include <algorithm>

namespace usar::server {

namespace {

constexpr std::size_t most_doors = 512;
constexpr std::size_t most_links = 512;
constexpr std::size_t most_remembered = 4096; // Bounds the cache, because clients may ask for any names.

} // namespace

void RadioField::forget() {
    stations_.reset();
    strengths_dbm_.clear();
}

const std::vector<sim::RadioStation>& RadioField::stations() {
    if (!stations_)
        stations_ = simulation_.radios();
    return *stations_;
}

const sim::RadioStation* RadioField::station(const std::string& name) {
    const auto& all = stations();
    const auto found = std::ranges::find(all, name, &sim::RadioStation::name);
    return found == all.end() || found->silent ? nullptr : &*found;
}

std::optional<double> RadioField::strength_dbm(const std::string& a, const std::string& b) {
    const auto pair = std::minmax(a, b);
    if (const auto known = strengths_dbm_.find(pair); known != strengths_dbm_.end())
        return known->second;
    const sim::RadioStation* const one = station(a);
    const sim::RadioStation* const other = station(b);
    std::optional<double> strength_dbm;
    if (one && other)
        strength_dbm = simulation_.radioStrength_dbm(*one, *other);
    if (strengths_dbm_.size() < most_remembered)
        strengths_dbm_[pair] = strength_dbm;
    return strength_dbm;
}

bool RadioField::reaches(const std::string& a, const std::string& b) {
    const auto strength = strength_dbm(a, b);
    return strength && *strength >= simulation_.options().radio.cutoff_dbm;
}

RadioRelay::RadioRelay(const sim::Simulation& simulation, QObject* parent) : QObject(parent), field_(simulation) {}

RadioRelay::~RadioRelay() {
    for (RelayedLink* const link : links_)
        link->disconnect(this);
}

quint16 RadioRelay::door(const std::string& from, const std::string& to, quint16 to_port) {
    const Way way{from, to, to_port};
    if (const auto known = doors_.find(way); known != doors_.end())
        return known->second.port;
    if (doors_.size() >= most_doors)
        return 0;
    Door door{std::make_unique<GuardedServer>(), 0};
    door.server->setAccess(access_);
    if (!door.server->open(0, ""))
        return 0;
    door.port = door.server->serverPort();
    connect(door.server.get(), &QTcpServer::newConnection, this, [this, way] { takeCalls(way); });
    turn(way, doors_[way] = std::move(door));
    return doors_.at(way).port;
}

void RadioRelay::turn(const Way& way, Door& door) {
    const bool open = field_.reaches(std::get<0>(way), std::get<1>(way));
    if (open && !door.server->isListening())
        door.server->listen(access_.address(), door.port); // If this fails, the next look() tries again.
    else if (!open && door.server->isListening())
        door.server->close();
}

void RadioRelay::takeCalls(const Way& way) {
    const auto& [from, to, to_port] = way;
    const auto found = doors_.find(way);
    while (found != doors_.end() && found->second.server->hasPendingConnections()) {
        QTcpSocket* const call = found->second.server->nextPendingConnection();
        if (links_.size() >= most_links || !field_.reaches(from, to)) {
            refuse(call);
            continue;
        }
        add(new RelayedLink(from, to, call, callRobot(to, to_port), LinkWords::None, this));
    }
}

bool RadioRelay::join(const std::string& from, quint16 from_port, const std::string& to, quint16 to_port) {
    if (links_.size() >= most_links || !field_.reaches(from, to))
        return false;
    add(new RelayedLink(from, to, callRobot(from, from_port), callRobot(to, to_port), LinkWords::Sends, this));
    return true;
}

void RadioRelay::setHost(const std::string& robot, const QHostAddress& host) {
    if (host.isLoopback())
        hosts_.erase(robot);
    else
        hosts_[robot] = host;
}

QTcpSocket* RadioRelay::callRobot(const std::string& robot, quint16 port) const {
    const auto known = hosts_.find(robot);
    return server::call(known == hosts_.end() ? QHostAddress(QHostAddress::LocalHost) : known->second, port);
}

void RadioRelay::add(RelayedLink* link) {
    links_.push_back(link);
    connect(link, &RelayedLink::ended, this, [this, link] {
        std::erase(links_, link);
        link->deleteLater();
    });
}

std::string RadioRelay::callerOf(const std::string& to, quint16 caller_port) const {
    const auto found = std::ranges::find_if(
        links_, [&](const RelayedLink* link) { return link->to() == to && link->callerPort() == caller_port; });
    return found == links_.end() ? std::string() : (*found)->from();
}

void RadioRelay::closeDoorsOf(const std::string& robot) {
    std::erase_if(doors_,
                  [&](const auto& one) { return std::get<0>(one.first) == robot || std::get<1>(one.first) == robot; });
}

void RadioRelay::look() {
    field_.forget();
    for (auto& [way, door] : doors_)
        turn(way, door);
    const std::vector<RelayedLink*> links = links_;
    for (RelayedLink* const link : links) {
        const auto strength_dbm = field_.strength_dbm(link->from(), link->to());
        if (field_.reaches(link->from(), link->to()))
            continue;
        emit logged(tr("radio: %1 and %2 have lost their link%3")
                        .arg(QString::fromStdString(link->from()), QString::fromStdString(link->to()),
                             strength_dbm ? tr(" at %1 dBm").arg(*strength_dbm, 0, 'f', 1) : QString()));
        link->drop();
    }
}

} // namespace usar::server
