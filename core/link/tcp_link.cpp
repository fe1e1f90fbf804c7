#include "core/link/tcp_link.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <QNetworkProxy>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/link/retry.h"

namespace usar::link {

namespace {

QString inWords(Seconds seconds) {
    const double value = seconds.count();
    return QString::fromStdString(fixed(value, value == std::floor(value) ? 0 : 1)) + QStringLiteral(" s");
}

} // namespace

std::string placeOf(const LinkStatus& status) {
    return status.host.toStdString() + ':' + std::to_string(status.port);
}

TcpLink::TcpLink(QObject* parent) : QObject(parent) {
    socket_->setProxy(QNetworkProxy::NoProxy);
    retry_timer_.setSingleShot(true);
    connect_timer_.setSingleShot(true);
    connect(&retry_timer_, &QTimer::timeout, this, &TcpLink::connectNow);
    connect(&connect_timer_, &QTimer::timeout, this, [this] {
        failed(QStringLiteral("No answer from %1 after %2. Is %3 running there?")
                   .arg(place(), inWords(limits_.connect_timeout), service_));
    });
    wire();
}

void TcpLink::wire() {
    connect(socket_, &QTcpSocket::connected, this, &TcpLink::takeConnection);
    connect(socket_, &QTcpSocket::readyRead, this, &TcpLink::takeBytes);
    connect(socket_, &QTcpSocket::errorOccurred, this, &TcpLink::takeError);
}

void TcpLink::useInProcess(InProcessServer server) {
    close();
    delete std::exchange(socket_, new InProcessSocket(std::move(server), this));
    wire();
}

TcpLink::~TcpLink() {
    socket_->disconnect(this);
}

void TcpLink::open(const QString& host, quint16 port) {
    close();
    status_.host = host.trimmed();
    status_.port = port;
    wanted_ = true;
    failed_tries_ = 0;
    connectNow();
}

void TcpLink::close() {
    wanted_ = false;
    retry_timer_.stop();
    const bool was_connected = status_.state == LinkState::Connected;
    if (was_connected)
        socket_->flush();
    dropConnection();
    setStatus(LinkState::Disconnected);
    if (was_connected)
        emit closed();
}

void TcpLink::send(std::string_view line) {
    if (status_.state != LinkState::Connected)
        return;
    socket_->write(line.data(), static_cast<qint64>(line.size()));
    socket_->write("\r\n", 2);
    ++counts_.lines_out;
    counts_.bytes_out += line.size() + 2;
    if (unsentBytes() > limits_.most_unsent_bytes) // Queued, because the caller may be in the middle of its own work.
        QMetaObject::invokeMethod(this, &TcpLink::failWhereNobodyReads, Qt::QueuedConnection);
}

void TcpLink::failWhereNobodyReads() {
    if (status_.state == LinkState::Connected && unsentBytes() > limits_.most_unsent_bytes)
        failed(QStringLiteral("The server at %1 reads no commands any more: %2 MB wait to be sent. Restart it.")
                   .arg(place(), QString::fromStdString(fixed(static_cast<double>(unsentBytes()) / 1e6, 1))));
}

std::optional<Seconds> TcpLink::roundTrip() const {
    if (status_.state != LinkState::Connected)
        return std::nullopt;
    tcp_info info{};
    socklen_t size = sizeof info;
    const int descriptor = static_cast<int>(socket_->socketDescriptor());
    if (getsockopt(descriptor, IPPROTO_TCP, TCP_INFO, &info, &size) != 0 || info.tcpi_rtt == 0)
        return std::nullopt;
    return std::chrono::microseconds(info.tcpi_rtt);
}

protocol::TrafficCounts TcpLink::counts() const {
    protocol::TrafficCounts counts = counts_;
    counts.dropped = splitter_.overlongCount() - overlong_before_;
    return counts;
}

void TcpLink::connectNow() {
    if (socket_->state() != QAbstractSocket::UnconnectedState) { // Still sending the last bytes of a closed connection.
        const QSignalBlocker quiet(socket_);
        socket_->abort();
    }
    setStatus(LinkState::Connecting);
    connect_timer_.start(toMilliseconds(limits_.connect_timeout));
    socket_->connectToHost(status_.host, status_.port);
}

void TcpLink::takeConnection() {
    connect_timer_.stop();
    splitter_.reset(); // Not in connectNow(), because a taker may reconnect in the middle of a chunk.
    greeting_.reset();
    counts_ = {};
    overlong_before_ = splitter_.overlongCount();
    socket_->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    socket_->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    setStatus(LinkState::Connected);
    emit opened();
}

void TcpLink::takeBytes() {
    std::array<char, 65536> buffer;
    while (status_.state == LinkState::Connected) {
        const qint64 count = socket_->read(buffer.data(), buffer.size());
        if (count <= 0)
            return;
        const std::string_view bytes(buffer.data(), static_cast<std::size_t>(count));
        counts_.bytes_in += bytes.size();
        if (take_bytes_)
            take_bytes_(bytes);
        greeting_.takeBytes(bytes);
        // Its own while they are given: a taker may run an event loop, in which more bytes come.
        std::vector<std::string_view> lines = std::exchange(lines_, {});
        splitter_.split(bytes, lines);
        if (take_ahead_ && lines.size() > 1 && greeting_.verdict() == GreetingCheck::Verdict::Usarsim)
            take_ahead_(lines);
        for (const std::string_view line : lines)
            giveLine(line);
        lines_ = std::move(lines);
        if (status_.state == LinkState::Connected && greeting_.verdict() == GreetingCheck::Verdict::Foreign)
            failed(foreignReason());
    }
}

void TcpLink::giveLine(std::string_view line) {
    if (greeting_.verdict() == GreetingCheck::Verdict::Unknown) {
        greeting_.takeLine(line);
        if (greeting_.verdict() == GreetingCheck::Verdict::Usarsim)
            failed_tries_ = 0;
    }
    // The taker may have closed the link on an earlier line of the same chunk.
    if (status_.state == LinkState::Connected && greeting_.verdict() != GreetingCheck::Verdict::Foreign && take_line_) {
        ++counts_.lines_in;
        take_line_(line);
    }
}

void TcpLink::takeError(QAbstractSocket::SocketError error) {
    if (error == QAbstractSocket::RemoteHostClosedError)
        takeBytes();
    // Reading the last bytes may already have led to a verdict on the connection.
    if (wanted_ && (status_.state == LinkState::Connected || status_.state == LinkState::Connecting))
        failed(greeting_.suspicious() ? foreignReason() : reasonOf(error));
}

QString TcpLink::foreignReason() const {
    return QStringLiteral("%1 does not speak %2. Check the port (usually %3).").arg(place(), service_).arg(usual_port_);
}

QString TcpLink::reasonOf(QAbstractSocket::SocketError error) const {
    switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
        return QStringLiteral("Nothing listens at %1. Start %2 there, or check the port (usually %3).")
            .arg(place(), service_)
            .arg(usual_port_);
    case QAbstractSocket::HostNotFoundError:
        return QStringLiteral("There is no host named \"%1\". Check the spelling, or type its address.")
            .arg(status_.host);
    case QAbstractSocket::RemoteHostClosedError:
        return QStringLiteral("The server at %1 closed the connection. Did it end, change its map, or is it full?")
            .arg(place());
    default:
        return QStringLiteral("Trouble with %1: %2. Check the network and the address.")
            .arg(place(), socket_->errorString());
    }
}

void TcpLink::failed(const QString& trouble) {
    const bool was_connected = status_.state == LinkState::Connected;
    dropConnection();
    const Seconds wait = retryPause(limits_.first_retry, limits_.longest_retry, failed_tries_);
    ++failed_tries_;
    retry_timer_.start(toMilliseconds(wait));
    setStatus(LinkState::Waiting, trouble, wait);
    if (was_connected)
        emit closed();
}

void TcpLink::dropConnection() {
    connect_timer_.stop();
    const QSignalBlocker quiet(socket_);
    // Ends gracefully first, so that queued bytes are still sent; aborts if none are queued or nothing was connected.
    if (socket_->state() == QAbstractSocket::ConnectedState)
        socket_->disconnectFromHost();
    if (socket_->state() != QAbstractSocket::UnconnectedState && socket_->bytesToWrite() == 0)
        socket_->abort();
}

void TcpLink::setStatus(LinkState state, const QString& trouble, Seconds retry_in) {
    LinkStatus next{state, status_.host, status_.port, trouble, trouble, retry_in};
    if (state == LinkState::Waiting)
        next.reason += QStringLiteral(" Retrying in %1.").arg(inWords(retry_in));
    if (next == status_)
        return;
    status_ = next;
    emit statusChanged(status_);
}

} // namespace usar::link
