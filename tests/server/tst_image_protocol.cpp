// The image server's protocol as bytes: requests and frames.
#include <QTest>
#include <QtEndian>

#include "core/base/random.h"
#include "core/server/image_protocol.h"
#include "tests/suite/suite.h"

namespace tst_image_protocol {

using namespace usar;
using namespace usar::server;

namespace {

sim::Picture gradient(int width_px, int height_px) {
    sim::Picture picture(width_px, height_px);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        picture.rgb[i] = static_cast<std::uint8_t>(i + 1);
    return picture;
}

} // namespace

class tst_ImageProtocol : public QObject {
    Q_OBJECT
private slots:
    void requestsAreTheseBytes_data() {
        QTest::addColumn<ImageRequest>("request");
        QTest::addColumn<QByteArray>("hex");
        QTest::newRow("the whole picture") << ImageRequest{} << QByteArray("4f4b");
        QTest::newRow("a part") << ImageRequest{ImageRequest::Part{1, 2, 300, 0x01020304}}
                                << QByteArray("5500000001000000020000012c01020304");
        QTest::newRow("nothing") << ImageRequest{ImageRequest::Part{}}
                                 << QByteArray("5500000000000000000000000000000000");
        QTest::newRow("the largest numbers")
            << ImageRequest{ImageRequest::Part{UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX}}
            << QByteArray("55ffffffffffffffffffffffffffffffff");
    }
    void requestsAreTheseBytes() {
        QFETCH(ImageRequest, request);
        QFETCH(QByteArray, hex);
        QCOMPARE(bytesOf(request).toHex(), hex);
        std::deque<ImageRequest> found;
        ImageRequestReader().feed(QByteArray::fromHex(hex).toStdString(), found);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found.front() == request);
    }

    void whatIsSentIsFoundInAnyChunksAndAmongOtherBytes() {
        Random random = seeded(11, 1);
        std::uniform_int_distribution<std::uint32_t> number;
        std::uniform_int_distribution<int> few(0, 3);
        std::uniform_int_distribution<std::size_t> chunk(1, 40);
        for (int round = 0; round < 200; ++round) {
            std::deque<ImageRequest> sent;
            std::string bytes;
            for (int i = 0; i < 10; ++i) {
                ImageRequest request;
                if (few(random) > 0)
                    request.part = {number(random), number(random), number(random), number(random)};
                bytes += bytesOf(request).toStdString();
                bytes.append(static_cast<std::size_t>(few(random)), '\n'); // not part of a request
                sent.push_back(request);
            }
            ImageRequestReader reader;
            std::deque<ImageRequest> found;
            for (std::string_view rest = bytes; !rest.empty();) {
                const std::string_view piece = rest.substr(0, chunk(random));
                reader.feed(piece, found);
                rest.remove_prefix(piece.size());
            }
            QVERIFY(found == sent);
        }
    }

    void rawFramesHaveRowsOfWholeWords_data() {
        QTest::addColumn<int>("width_px");
        QTest::addColumn<int>("row_bytes");
        QTest::newRow("one pixel") << 1 << 4;
        QTest::newRow("two") << 2 << 8;
        QTest::newRow("three") << 3 << 12;
        QTest::newRow("four") << 4 << 12;
        QTest::newRow("five") << 5 << 16;
        QTest::newRow("three hundred and twenty") << 320 << 960;
    }
    void rawFramesHaveRowsOfWholeWords() {
        QFETCH(int, width_px);
        QFETCH(int, row_bytes);
        constexpr int height_px = 3;
        const sim::Picture picture = gradient(width_px, height_px);
        const QByteArray frame = frameOf(picture, link::ImageType::Raw);
        QCOMPARE(frame.size(), qsizetype(5 + 4 + row_bytes * height_px));
        QCOMPARE(frame[0], '\0');
        QCOMPARE(qFromBigEndian<quint32>(frame.constData() + 1), quint32(frame.size() - 5));
        QCOMPARE(int(qFromBigEndian<quint16>(frame.constData() + 5)), width_px);
        QCOMPARE(int(qFromBigEndian<quint16>(frame.constData() + 7)), height_px);
        for (int y = 0; y < height_px; ++y) {
            const QByteArray row = frame.mid(9 + y * row_bytes, row_bytes);
            for (int x = 0; x < width_px; ++x)
                for (int channel = 0; channel < 3; ++channel)
                    QCOMPARE(static_cast<std::uint8_t>(row[3 * x + channel]), picture.at(x, y)[2 - channel]);
            QCOMPARE(row.mid(3 * width_px), QByteArray(row_bytes - 3 * width_px, '\0'));
        }
    }

    void jpegFramesSayTheirTypeAndSize_data() {
        QTest::addColumn<int>("type");
        QTest::newRow("superb") << int(link::ImageType::Superb);
        QTest::newRow("good") << int(link::ImageType::Good);
        QTest::newRow("normal") << int(link::ImageType::Normal);
        QTest::newRow("fair") << int(link::ImageType::Fair);
        QTest::newRow("bad") << int(link::ImageType::Bad);
    }
    void jpegFramesSayTheirTypeAndSize() {
        QFETCH(int, type);
        const QByteArray frame = frameOf(gradient(40, 30), static_cast<link::ImageType>(type));
        QCOMPARE(int(frame[0]), type);
        QCOMPARE(qFromBigEndian<quint32>(frame.constData() + 1), quint32(frame.size() - 5));
        QVERIFY(frame.mid(5).startsWith("\xFF\xD8") && frame.endsWith("\xFF\xD9"));
    }
};

USAR_TEST(tst_ImageProtocol)

} // namespace tst_image_protocol

#include "tst_image_protocol.moc"
