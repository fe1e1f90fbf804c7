// Frames of an image server as pictures, and what cannot be one.
#include <QBuffer>
#include <QImage>
#include <QTest>

#include "core/mission/fleet/camera_feed.h"
#include "tests/suite/suite.h"

namespace tst_camera_picture {

using namespace usar;
using namespace usar::mission;
using link::ImageType;

namespace {

QByteArray jpegOf(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "jpeg");
    return bytes;
}

QByteArray raw(int width, int height, qsizetype pixel_bytes) {
    QByteArray bytes;
    for (const int number : {width, height})
        bytes.append(static_cast<char>(number >> 8)).append(static_cast<char>(number & 0xFF));
    return bytes.append(QByteArray(pixel_bytes, '\0'));
}

QImage oneColor(QSize size) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(QColor(200, 30, 90));
    return image;
}

} // namespace

class tst_CameraPicture : public QObject {
    Q_OBJECT

private slots:
    void aJpegIsRead() {
        const auto picture = cameraPictureOf(ImageType::Good, jpegOf(oneColor({40, 30})));
        QVERIFY(picture);
        QCOMPARE(picture->size(), QSize(40, 30));
        QVERIFY(std::abs(qRed(picture->pixel(5, 5)) - 200) < 6);
    }

    void rawPixelsAreBlueGreenRedInFilledRows() {
        QByteArray bytes = raw(3, 2, 24); // three pixels are nine bytes, filled up to twelve
        bytes[4 + 12 + 3] = static_cast<char>(10);
        bytes[4 + 12 + 4] = static_cast<char>(20);
        bytes[4 + 12 + 5] = static_cast<char>(30);
        const auto picture = cameraPictureOf(ImageType::Raw, bytes);
        QVERIFY(picture);
        QCOMPARE(picture->size(), QSize(3, 2));
        QCOMPARE(picture->pixelColor(1, 1), QColor(30, 20, 10));
    }

    void whatIsNoPictureIsRefused_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<QByteArray>("data");
        const QByteArray jpeg = jpegOf(oneColor({40, 30}));
        QTest::newRow("nothing") << 2 << QByteArray();
        QTest::newRow("words") << 2 << QByteArray("no picture at all");
        QTest::newRow("another format") << 2 << QByteArray("\x89PNG\r\n\x1a\n0000IHDR");
        QTest::newRow("a JPEG's first bytes") << 3 << jpeg.left(20);
        QTest::newRow("too wide a JPEG") << 2 << jpegOf(oneColor({5000, 4}));
        QTest::newRow("raw without a size") << 0 << QByteArray("abc");
        QTest::newRow("raw of no size") << 0 << raw(0, 10, 100);
        QTest::newRow("raw that ends early") << 0 << raw(10, 10, 31 * 10);
        QTest::newRow("raw that claims to be huge") << 0 << raw(65535, 65535, 100);
    }

    void whatIsNoPictureIsRefused() {
        QFETCH(int, type);
        QFETCH(QByteArray, data);
        const auto picture = cameraPictureOf(static_cast<ImageType>(type), data);
        QVERIFY(!picture);
        QVERIFY(QString::fromStdString(picture.error().text()).contains("image server"));
    }
};

USAR_TEST(tst_CameraPicture)

} // namespace tst_camera_picture

#include "tst_camera_picture.moc"
