#include "core/link/wireless_client.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/numbers.h"
#include "core/protocol/segments.h"
#include "core/protocol/usual_values.h"

namespace usar::link {

WirelessClient::WirelessClient() {
    setInterval(std::chrono::seconds{1});
    connect(&timer_, &QTimer::timeout, this, &WirelessClient::ask);
}

void WirelessClient::open(const QString& host, quint16 port) {
    host_ = host;
    port_ = port;
    restart();
}

void WirelessClient::close() {
    host_.clear();
    restart();
}

void WirelessClient::setRobots(const QStringList& names) {
    if (names == robots_)
        return;
    const bool was_enough = robots_.size() >= 2;
    robots_ = names;
    if (!was_enough || robots_.size() < 2)
        return restart();
    if (!members_.empty())
        openMembers();
    report(); // Robots that have been removed disappear at once.
}

void WirelessClient::restart() {
    observer_.reset();
    members_.clear();
    round_.clear();
    awaited_ = 0;
    observer_number_ = 1;
    if (host_.isEmpty() || robots_.size() < 2) {
        timer_.stop();
        emit reported({});
    } else {
        observer_ = makeLine(QStringLiteral("MissionControl"));
        timer_.start();
    }
    showStatus();
}

std::unique_ptr<WirelessClient::Line> WirelessClient::makeLine(const QString& name) {
    auto line = std::make_unique<Line>();
    Line* const one = line.get();
    one->name = name;
    one->link.setService(QStringLiteral("WSS"), protocol::usual_port::wireless);
    one->link.setLimits(limits_);
    one->link.setLineTaker([this, one](std::string_view said) { take(*one, said); });
    connect(&one->link, &TcpLink::opened, this, [one] {
        one->initialized = one->refused = false;
        one->introduce();
    });
    connect(&one->link, &TcpLink::statusChanged, this, &WirelessClient::showStatus);
    one->link.open(host_, port_);
    return line;
}

void WirelessClient::openMembers() {
    std::erase_if(members_, [this](const auto& one) { return !robots_.contains(one.first); });
    for (const QString& robot : robots_)
        if (!members_.contains(robot))
            members_[robot] = makeLine(robot);
}

void WirelessClient::take(Line& line, std::string_view said) {
    Diagnostics diagnostics;
    protocol::Segments segments;
    segments.read(said, diagnostics);
    if (segments.typeWord() == "INITREPLY") {
        line.initialized = true;
        line.refused = false;
        if (&line == observer_.get())
            ask();
    } else if (segments.typeWord() == "ERROR") {
        takeError(line, segments.value("Reason"));
    } else if (segments.typeWord() == "SS") {
        takeStrength(line, segments.value("Robot"), segments.value("From"), segments.value("Strength"));
    }
}

void WirelessClient::takeError(Line& line, std::string_view reason) {
    if (line.initialized || reason.find("Exist") == std::string_view::npos)
        return;
    line.refused = true;
    if (&line != observer_.get())
        return;
    line.name = QStringLiteral("MissionControl-%1").arg(++observer_number_);
    line.introduce();
}

void WirelessClient::takeStrength(Line& line, std::string_view robot, std::string_view from,
                                  std::string_view strength) {
    if (&line == observer_.get() && from.empty()) { // The server does not know {From}: ask as the robots themselves.
        // Queued, because the line is still working on what it has received.
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (!observer_)
                    return;
                observer_.reset();
                awaited_ = 0;
                openMembers();
                showStatus();
            },
            Qt::QueuedConnection);
        return;
    }
    const Pair pair = std::minmax({from.empty() ? line.name : QString::fromUtf8(from), QString::fromUtf8(robot)});
    const auto dbm = readNumber(strength);
    round_[pair] = dbm && std::isfinite(*dbm) ? dbm : std::nullopt;
    if (awaited_ > 0 && --awaited_ == 0)
        report();
}

WirelessClient::Line* WirelessClient::speakerOf(const QString& robot) {
    const auto member = members_.find(robot);
    return member != members_.end() && member->second->speaks() ? member->second.get() : nullptr;
}

void WirelessClient::ask() {
    if (awaited_ > 0)
        report(); // The answers of the last round that have arrived.
    round_.clear();
    awaited_ = 0;
    for (const auto& [robot, line] : members_)
        if (line->refused)
            line->introduce(); // The name may be free again.
    for (qsizetype i = 0; i < robots_.size(); ++i)
        for (qsizetype j = i + 1; j < robots_.size(); ++j)
            askFor({robots_[i], robots_[j]});
    if (awaited_ == 0)
        report(); // Nobody can be asked, so nothing is known.
}

void WirelessClient::askFor(const Pair& pair) {
    const auto question = [](const QString& robot) { return "GETSS {Robot " + robot.toStdString() + "}"; };
    if (observer_) {
        if (!observer_->speaks())
            return;
        observer_->link.send(question(pair.second) + " {From " + pair.first.toStdString() + "}");
    } else if (Line* const first = speakerOf(pair.first)) {
        first->link.send(question(pair.second));
    } else if (Line* const second = speakerOf(pair.second)) {
        second->link.send(question(pair.first));
    } else {
        return;
    }
    ++awaited_;
}

void WirelessClient::report() {
    awaited_ = 0;
    RadioStrengths strengths;
    for (const auto& [pair, strength_dbm] : round_)
        if (robots_.contains(pair.first) && robots_.contains(pair.second))
            strengths.push_back({pair.first, pair.second, strength_dbm});
    emit reported(strengths);
}

/// Shows the status of the best line: a connected one, else a waiting one, else a connecting one.
void WirelessClient::showStatus() {
    LinkStatus best;
    const auto rank = [](const LinkStatus& status) {
        static constexpr std::array ranks{0, 1, 3, 2}; // Disconnected, Connecting, Connected, Waiting
        return ranks[static_cast<std::size_t>(status.state)];
    };
    const auto consider = [&](const Line& line) {
        if (rank(line.link.status()) > rank(best))
            best = line.link.status();
    };
    if (observer_)
        consider(*observer_);
    for (const auto& [robot, line] : members_)
        consider(*line);
    if (best == status_)
        return;
    status_ = best;
    emit statusChanged(status_);
}

} // namespace usar::link
