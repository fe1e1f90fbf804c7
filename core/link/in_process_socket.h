// A connection between two objects of one thread, in place of TCP.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>

#include <QObject>
#include <QPointer>
#include <QTcpSocket>

namespace usar::link {

/// Takes the server's end of a new connection, and owns it from then on.
using InProcessServer = std::function<void(QTcpSocket* accepted)>;

/// Carries the same bytes as TCP, in the same order, but asks neither the system nor the event loop for each of them:
/// client and server take turns until both have nothing more to say, or for 10 ms at most, so that timers and other
/// events get their turn, too. Nothing is delivered while `write` is on the stack. It has no address and no options,
/// and any number of bytes may wait to be read.
class InProcessSocket : public QTcpSocket {
    Q_OBJECT
public:
    /// The client's end; each `connectToHost`, whatever the host, makes another connection to the server.
    explicit InProcessSocket(InProcessServer server, QObject* parent = nullptr);
    ~InProcessSocket() override;

    using QTcpSocket::connectToHost;
    void connectToHost(const QString& host, quint16 port, OpenMode mode, NetworkLayerProtocol protocol) override;
    void disconnectFromHost() override { leave(); }
    void close() override { leave(); }
    qint64 bytesAvailable() const override;
    /// Bytes that the other end has not read.
    qint64 bytesToWrite() const override;

protected:
    qint64 readData(char* data, qint64 most) override;
    qint64 writeData(const char* data, qint64 size) override;

private:
    class Turns;

    InProcessSocket(std::shared_ptr<Turns> turns, InProcessSocket& client);
    void becomeConnected();
    /// Ends the connection at this end; the other end hears of it after it has read what was written.
    void leave();
    /// Tells what has happened at the other end.
    void deliver();

    InProcessServer server_; ///< empty at the server's end
    std::shared_ptr<Turns> turns_;
    QPointer<InProcessSocket> peer_;
    std::string received_;    ///< from the other end
    std::size_t read_ = 0;    ///< bytes of it that were read
    bool left_alone_ = false; ///< the other end is gone
};

} // namespace usar::link
