#include "core/link/in_process_socket.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <QElapsedTimer>
#include <QMetaObject>

namespace usar::link {

namespace {

constexpr qint64 turn_ms = 10;

} // namespace

/// The ends of a connection that have something to hear, in the order in which it happened.
class InProcessSocket::Turns : public std::enable_shared_from_this<Turns> {
public:
    void add(InProcessSocket& socket) {
        if (std::ranges::none_of(due_, [&](const auto& one) { return one == &socket; }))
            due_.emplace_back(&socket);
        post(); // Also while turns are taken: a slot may run an event loop of its own.
    }

private:
    void post() {
        if (!std::exchange(posted_, true))
            QMetaObject::invokeMethod(
                &context_, [this] { run(); }, Qt::QueuedConnection);
    }
    void run() {
        const auto self = shared_from_this(); // Both ends may go meanwhile.
        posted_ = false;
        QElapsedTimer since;
        since.start();
        while (!due_.empty() && since.elapsed() < turn_ms) {
            const QPointer<InProcessSocket> next = due_.front();
            due_.pop_front();
            if (next)
                next->deliver();
        }
        if (!due_.empty())
            post();
    }

    QObject context_; ///< in whose thread the turns are taken
    std::deque<QPointer<InProcessSocket>> due_;
    bool posted_ = false;
};

InProcessSocket::InProcessSocket(InProcessServer server, QObject* parent)
    : QTcpSocket(parent)
    , server_(std::move(server))
    , turns_(std::make_shared<Turns>()) {}

InProcessSocket::InProcessSocket(std::shared_ptr<Turns> turns, InProcessSocket& client)
    : turns_(std::move(turns))
    , peer_(&client) {
    becomeConnected();
}

InProcessSocket::~InProcessSocket() {
    const QSignalBlocker quiet(this);
    leave();
}

void InProcessSocket::connectToHost(const QString&, quint16, OpenMode, NetworkLayerProtocol) {
    leave();
    left_alone_ = false;
    setSocketState(ConnectingState);
    turns_->add(*this);
}

void InProcessSocket::becomeConnected() {
    received_.clear();
    read_ = 0;
    left_alone_ = false;
    setOpenMode(ReadWrite | Unbuffered);
    setSocketState(ConnectedState);
}

void InProcessSocket::leave() {
    if (state() == UnconnectedState)
        return;
    const bool was_connected = state() == ConnectedState;
    received_.clear();
    read_ = 0;
    if (const QPointer<InProcessSocket> other = std::exchange(peer_, nullptr)) {
        other->peer_ = nullptr; // This end may be on its next connection when the other one leaves.
        other->left_alone_ = true;
        turns_->add(*other);
    }
    QIODevice::close();
    setSocketState(UnconnectedState);
    if (was_connected)
        emit disconnected();
}

void InProcessSocket::deliver() {
    const QPointer<InProcessSocket> self = this; // Each slot may delete this end.
    if (state() == ConnectingState) {
        auto* const accepted = new InProcessSocket(turns_, *this);
        peer_ = accepted;
        becomeConnected();
        server_(accepted);
        if (self)
            emit connected();
    }
    if (self && state() == ConnectedState && bytesAvailable() > 0)
        emit readyRead();
    const auto is_left_alone = [&] { return self && left_alone_ && state() == ConnectedState; };
    if (!is_left_alone())
        return;
    setSocketError(RemoteHostClosedError);
    emit errorOccurred(RemoteHostClosedError);
    if (is_left_alone()) // Unless a slot has begun another connection.
        leave();
}

qint64 InProcessSocket::bytesAvailable() const {
    return static_cast<qint64>(received_.size() - read_);
}

qint64 InProcessSocket::bytesToWrite() const {
    return peer_ ? peer_->bytesAvailable() : 0;
}

qint64 InProcessSocket::readData(char* data, qint64 most) {
    const std::size_t count = std::min(static_cast<std::size_t>(most), received_.size() - read_);
    std::memcpy(data, received_.data() + read_, count);
    read_ += count;
    if (read_ == received_.size()) {
        received_.clear();
        read_ = 0;
    }
    return static_cast<qint64>(count);
}

qint64 InProcessSocket::writeData(const char* data, qint64 size) {
    if (!peer_)
        return size; // As with TCP, whoever writes before hearing that the other end is gone is told nothing.
    peer_->received_.append(data, static_cast<std::size_t>(size));
    turns_->add(*peer_);
    return size;
}

} // namespace usar::link
