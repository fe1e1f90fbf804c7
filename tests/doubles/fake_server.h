// A server that says what a test tells it to: scripted lines in any chunks, garbage, half lines, silence.
#pragma once

#include <functional>

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QTcpServer>
#include <QTcpSocket>

namespace usar::test {

/// Loopback only. Answers whoever asks; what it says of itself goes to the newest client, or to the one that it keeps
/// to. Lives in the test's thread, or in the one that it is moved to.
class FakeServer : public QObject {
    Q_OBJECT
public:
    explicit FakeServer(QObject* parent = nullptr);

    /// A free port when `port` is 0.
    bool listen(quint16 port = 0);
    quint16 port() const { return server_.serverPort(); }
    void stopListening() { server_.close(); }

    /// Called for each new client, and for each line that a client sent (without its terminator).
    std::function<void()> on_connect;
    std::function<void(const QByteArray& line)> on_line;

    /// From now on talks to the client whose line is being obeyed; others may connect and hear nothing.
    void keepClient() { kept_ = speaking_; }

    void say(const QByteArray& bytes);
    /// One write per `chunk_size` bytes, each pushed out at once.
    void sayInChunks(const QByteArray& bytes, qsizetype chunk_size);
    void hangUp();
    /// Deaf, it leaves what the client sends in the network, which takes little of it; hearing again, it takes all.
    void setDeaf(bool on);

    bool hasClient() const { return client_ && client_->state() == QAbstractSocket::ConnectedState; }
    int connectionCount() const { return connection_count_; }
    const QList<QByteArray>& heard() const { return heard_; }
    /// The lines heard that begin so.
    QList<QByteArray> heardOf(const QByteArray& word) const;
    void forget() { heard_.clear(); }

private:
    void accept();
    void read(QTcpSocket* socket);

    QTcpServer server_{this}; ///< a child, so that it moves to another thread, too
    QPointer<QTcpSocket> client_;
    QPointer<QTcpSocket> kept_;     ///< the only one, when set
    QPointer<QTcpSocket> speaking_; ///< while its line is obeyed
    QList<QByteArray> heard_;
    int connection_count_ = 0;
    bool deaf_ = false;
};

} // namespace usar::test
