#include "core/server/relayed_link.h"

#include <algorithm>
#include <utility>

#include <QTimer>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::server {

namespace {

constexpr qint64 most_held_bytes = 64 << 10;

constexpr std::size_t word_bytes = 5; ///< length of "SEND " and of "CLOSE"
constexpr std::size_t most_digits = 9;

} // namespace

bool ComFrames::feed(std::string_view bytes, const Take& take) {
    while (!bytes.empty() && state_ != State::Closed) {
        if (state_ != State::Payload) {
            takeOne(bytes.front());
            bytes.remove_prefix(1);
            continue;
        }
        const std::size_t count = std::min(left_, bytes.size());
        take(bytes.substr(0, count));
        bytes.remove_prefix(count);
        left_ -= count;
        if (left_ == 0)
            state_ = State::End;
    }
    return state_ != State::Closed;
}

void ComFrames::takeOne(char c) {
    switch (state_) {
    case State::Between:
        if (isSpace(c) || c == ';')
            return;
        word_.clear();
        state_ = State::Word;
        [[fallthrough]];
    case State::Word:
        word_ += c;
        if (c == ';') // Too short for any word.
            state_ = State::Between;
        else if (word_ == "SEND ")
            state_ = State::Length;
        else if (word_.size() == word_bytes)
            state_ = State::Skip;
        if (state_ == State::Length)
            word_.clear();
        return;
    case State::Length:
        if (c == ' ' && !word_.empty()) {
            left_ = static_cast<std::size_t>(readInteger(word_).value_or(0));
            state_ = left_ > 0 ? State::Payload : State::End;
        } else if (c < '0' || c > '9' || word_.size() == most_digits) {
            word_.clear();
            state_ = c == ';' ? State::Between : State::Skip;
        } else {
            word_ += c;
        }
        return;
    case State::Skip:
        if (c == ';')
            state_ = word_ == "CLOSE" ? State::Closed : State::Between;
        return;
    case State::End:
        state_ = State::Between;
        return;
    case State::Payload:
    case State::Closed:
        return;
    }
}

RelayedLink::RelayedLink(std::string from, std::string to, QTcpSocket* near_end, QTcpSocket* far_end, LinkWords words,
                         QObject* parent)
    : QObject(parent)
    , from_(std::move(from))
    , to_(std::move(to))
    , near_(near_end)
    , far_(far_end)
    , caller_port_(far_end->localPort()) {
    if (words == LinkWords::Sends)
        frames_.emplace();
    for (QTcpSocket* const socket : {near_, far_}) {
        socket->setParent(this);
        socket->setReadBufferSize(most_held_bytes);
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    }
    join(*near_, *far_, 0);
    join(*far_, *near_, 1);
    // Queued, so that the owner can connect to ended() before it may be emitted.
    QMetaObject::invokeMethod(
        this,
        [this] {
            carry(*near_, *far_, 0);
            carry(*far_, *near_, 1);
        },
        Qt::QueuedConnection);
}

RelayedLink::~RelayedLink() {
    near_->disconnect(this);
    far_->disconnect(this);
}

void RelayedLink::join(QTcpSocket& in, QTcpSocket& out, std::size_t way) {
    connect(&in, &QTcpSocket::readyRead, this, [this, &in, &out, way] { carry(in, out, way); });
    connect(&out, &QTcpSocket::bytesWritten, this, [this, &in, &out, way] { carry(in, out, way); });
    // Queued, because a socket may emit these in the middle of carry(). A socket that never connected emits only an
    // error.
    connect(
        &in, &QTcpSocket::errorOccurred, this, [this, &in, &out, way] { finish(in, out, way); }, Qt::QueuedConnection);
    connect(
        &in, &QTcpSocket::disconnected, this, [this, &in, &out, way] { finish(in, out, way); }, Qt::QueuedConnection);
}

void RelayedLink::carry(QTcpSocket& in, QTcpSocket& out, std::size_t way) {
    while (!ended_ && in.bytesAvailable() > 0 && out.bytesToWrite() < most_held_bytes) {
        const QByteArray bytes = in.read(most_held_bytes);
        if (!frames_) {
            out.write(bytes);
            continue;
        }
        const std::string_view said(bytes.constData(), static_cast<std::size_t>(bytes.size()));
        const bool open = (*frames_)[way].feed(
            said, [&](std::string_view payload) { out.write(payload.data(), static_cast<qint64>(payload.size())); });
        if (!open)
            in.disconnectFromHost();
    }
    if (!ended_ && in.state() == QAbstractSocket::UnconnectedState && in.bytesAvailable() == 0)
        out.disconnectFromHost();
}

void RelayedLink::finish(QTcpSocket& gone, QTcpSocket& other, std::size_t way) {
    if (gone.state() != QAbstractSocket::UnconnectedState)
        return;
    carry(gone, other, way);
    if (other.state() == QAbstractSocket::UnconnectedState)
        end();
    else
        QTimer::singleShot(5000, this, &RelayedLink::drop); // The other end may read the last bytes until then.
}

void RelayedLink::drop() {
    for (QTcpSocket* const socket : {near_, far_}) {
        socket->disconnect(this);
        socket->abort();
    }
    end();
}

void RelayedLink::end() {
    if (!std::exchange(ended_, true))
        emit ended();
}

} // namespace usar::server
