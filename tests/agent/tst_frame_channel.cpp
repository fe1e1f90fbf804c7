// Frames over a socket whose other end writes as it likes.
#include <sys/socket.h>
#include <unistd.h>

#include <QByteArray>
#include <QByteArrayList>
#include <QObject>
#include <QTest>
#include <QtEndian>

#include "core/agent/process/frame_channel.h"
#include "tests/suite/suite.h"

namespace tst_frame_channel {

using namespace usar;
using namespace usar::agent;
using Received = FrameChannel::Received;

class tst_FrameChannel : public QObject {
    Q_OBJECT

    int ends_[2] = {-1, -1};

    void write(const QByteArray& bytes) {
        QCOMPARE(::send(ends_[1], bytes.constData(), static_cast<std::size_t>(bytes.size()), MSG_NOSIGNAL),
                 static_cast<ssize_t>(bytes.size()));
    }
    static QByteArray framed(const QByteArray& frame) {
        QByteArray bytes(sizeof(quint32), Qt::Uninitialized);
        qToLittleEndian(static_cast<quint32>(frame.size()), bytes.data());
        return bytes + frame;
    }

private slots:
    void init() { QCOMPARE(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_), 0); }
    void cleanup() { ::close(ends_[1]); }

    void aFrameThatComesByteByByteIsWhole() {
        FrameChannel channel(ends_[0]);
        const QByteArray bytes = framed("one") + framed("") + framed("three");
        QByteArrayList got;
        for (const char byte : bytes) {
            write(QByteArray(1, byte));
            QByteArray frame("old");
            if (channel.receive(frame, Seconds{0.0}) == Received::Frame)
                got << frame;
        }
        QCOMPARE(got, QByteArrayList({"one", "", "three"}));
    }

    void framesThatComeTogetherAreTakenOneByOne() {
        FrameChannel channel(ends_[0]);
        write(framed("one") + framed("two") + framed("three").chopped(1));
        QByteArray frame;
        QCOMPARE(channel.receive(frame, Seconds{0.0}), Received::Frame);
        QCOMPARE(frame, QByteArray("one"));
        QCOMPARE(channel.receive(frame, Seconds{0.0}), Received::Frame);
        QCOMPARE(frame, QByteArray("two"));
        QCOMPARE(channel.receive(frame, Seconds{0.0}), Received::TimedOut);
        QCOMPARE(frame, QByteArray("two"));
        write("e");
        QCOMPARE(channel.receive(frame, Seconds{0.0}), Received::Frame);
        QCOMPARE(frame, QByteArray("three"));
    }

    void aTornFrameAndOneOfAMadLengthAreTheEnd_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("torn") << framed("three").chopped(1);
        QTest::newRow("torn in its length") << framed("three").first(2);
        QTest::newRow("a mad length") << QByteArray("\xff\xff\xff\xff", 4);
    }

    void aTornFrameAndOneOfAMadLengthAreTheEnd() {
        QFETCH(QByteArray, bytes);
        FrameChannel channel(ends_[0]);
        write(bytes);
        ::shutdown(ends_[1], SHUT_WR);
        QByteArray frame;
        QCOMPARE(channel.receive(frame, Seconds{1.0}), Received::Closed);
    }
};

USAR_TEST(tst_FrameChannel)

} // namespace tst_frame_channel

#include "tst_frame_channel.moc"
