#include "core/server/request_server.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::server {

namespace {

constexpr std::size_t longest_request = 4096;
constexpr int pieces_a_turn = 4;
constexpr qint64 most_unread_bytes = 64 << 10;

} // namespace

std::optional<quint16> readPort(std::string_view text) {
    const auto port = readInteger(text);
    if (!port || *port < 0 || *port > 65535)
        return std::nullopt;
    return static_cast<quint16>(*port);
}

RequestServer::RequestServer(std::string ends, std::string option, QObject* parent)
    : QObject(parent)
    , ends_(std::move(ends))
    , option_(std::move(option)) {
    connect(&server_, &QTcpServer::newConnection, this, &RequestServer::acceptAll);
}

RequestServer::~RequestServer() {
    for (const auto& [id, client] : clients_)
        client.socket->disconnect(this);
}

void RequestServer::acceptAll() {
    while (QTcpSocket* const socket = server_.nextPendingConnection()) {
        if (clients_.size() >= most_clients_ && !makeRoom()) {
            refuse(socket);
            continue;
        }
        const int id = ++last_client_;
        clients_[id].socket = socket;
        socket->setReadBufferSize(pieces_a_turn * static_cast<qint64>(longest_request));
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        connect(socket, &QTcpSocket::readyRead, this, [this, id] { serve(id); });
        connect(socket, &QTcpSocket::bytesWritten, this, [this, id] { serveLater(id); });
        connect(
            socket, &QTcpSocket::disconnected, this, [this, id] { forget(id); }, Qt::QueuedConnection);
        serveLater(id); // Bytes may have arrived before the signals were connected.
    }
}

bool RequestServer::makeRoom() {
    const auto silent = std::ranges::find_if(clients_, [](const auto& one) { return !one.second.has_asked; });
    if (silent == clients_.end())
        return false;
    silent->second.socket->disconnect(this);
    refuse(silent->second.socket);
    clients_.erase(silent);
    return true;
}

void RequestServer::serveLater(int client) {
    const auto found = clients_.find(client);
    if (found == clients_.end() || std::exchange(found->second.due, true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this, client] {
            if (const auto there = clients_.find(client); there != clients_.end()) {
                there->second.due = false;
                serve(client);
            }
        },
        Qt::QueuedConnection);
}

void RequestServer::serve(int client) {
    const auto found = clients_.find(client);
    if (found == clients_.end())
        return;
    QTcpSocket& socket = *found->second.socket;
    std::array<char, longest_request> piece;
    for (int i = 0; i < pieces_a_turn; ++i) {
        if (socket.bytesToWrite() > most_unread_bytes)
            return; // Continues when the client has read.
        const qint64 count = socket.read(piece.data(), piece.size());
        if (count <= 0)
            return;
        take(client, {piece.data(), static_cast<std::size_t>(count)});
    }
    if (socket.bytesAvailable() > 0)
        serveLater(client); // After the other clients have had their turn.
}

void RequestServer::take(int id, std::string_view bytes) {
    Client& client = clients_.at(id);
    while (!bytes.empty()) {
        const std::size_t end = bytes.find_first_of(ends_);
        const std::string_view part = bytes.substr(0, end);
        client.dropping = client.dropping || client.pending.size() + part.size() > longest_request;
        if (client.dropping)
            client.pending.clear();
        else
            client.pending += part;
        if (end == std::string_view::npos)
            return;
        bytes.remove_prefix(end + 1);
        const std::string request = std::exchange(client.pending, {});
        if (std::exchange(client.dropping, false) || trimmed(request).empty())
            continue;
        client.has_asked = true;
        const std::string reply = answer(id, trimmed(request));
        client.socket->write(reply.data(), static_cast<qint64>(reply.size()));
    }
}

void RequestServer::forget(int client) {
    const auto found = clients_.find(client);
    if (found == clients_.end())
        return;
    serve(client); // Takes the last bytes that it sent.
    found->second.socket->deleteLater();
    clients_.erase(found);
    leave(client);
}

} // namespace usar::server
