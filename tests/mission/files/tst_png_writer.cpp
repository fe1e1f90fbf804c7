#include <QBuffer>
#include <QImage>
#include <QImageWriter>
#include <QTest>

#include "core/base/random.h"
#include "core/mission/files/png_writer.h"
#include "tests/suite/suite.h"

namespace tst_png_writer {

using namespace usar;

namespace {

QByteArray written(const QImage& picture) {
    QByteArray bytes;
    const bool all = mission::writePng(picture, [&](const char* data, std::size_t size) {
        bytes.append(data, static_cast<qsizetype>(size));
        return true;
    });
    return all ? bytes : QByteArray();
}

QImage noise(int width, int height, QImage::Format format) {
    QImage picture(width, height, QImage::Format_RGB32);
    Random random = seeded(1, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.setPixel(x, y, 0xff000000u | static_cast<QRgb>(random()));
    return picture.convertToFormat(format);
}

/// A map of cells: squares of equal pixels.
QImage squares() {
    return noise(50, 40, QImage::Format_RGB32).scaled(600, 480, Qt::IgnoreAspectRatio, Qt::FastTransformation);
}

} // namespace

class tst_PngWriter : public QObject {
    Q_OBJECT
private slots:
    void othersReadWhatWasWritten_data() {
        QTest::addColumn<QImage>("picture");
        QTest::newRow("one pixel") << noise(1, 1, QImage::Format_RGB32);
        QTest::newRow("rows of an odd length") << noise(13, 7, QImage::Format_RGB32);
        QTest::newRow("of another format") << noise(9, 5, QImage::Format_RGB888);
        QTest::newRow("longer than a piece") << noise(300, 200, QImage::Format_RGB32);
        QTest::newRow("cells of a map") << squares();
    }
    void othersReadWhatWasWritten() {
        QFETCH(QImage, picture);
        picture.setDotsPerMeterX(1234);
        picture.setDotsPerMeterY(4321);
        picture.setText("level", "DM-tall_test");
        picture.setText("area", "20 m²");
        const QImage read = QImage::fromData(written(picture), "PNG");
        QCOMPARE(read.convertToFormat(QImage::Format_RGB32), picture.convertToFormat(QImage::Format_RGB32));
        QCOMPARE(read.dotsPerMeterX(), 1234);
        QCOMPARE(read.dotsPerMeterY(), 4321);
        QCOMPARE(read.text("level"), QString("DM-tall_test"));
        QCOMPARE(read.text("area"), QString("20 m²"));
    }

    void aMapTakesNoMoreThanByQt() {
        QBuffer of_qt;
        of_qt.open(QIODevice::WriteOnly);
        QImageWriter writer(&of_qt, "png");
        writer.setQuality(66); // zlib's level 3, too.
        QVERIFY(writer.write(squares()));
        QVERIFY2(written(squares()).size() <= of_qt.size(),
                 qPrintable(QString("%1 > %2").arg(written(squares()).size()).arg(of_qt.size())));
    }

    void stopsWhereTheSinkTakesNoMore_data() {
        QTest::addColumn<int>("calls");
        QTest::newRow("at once") << 0;
        QTest::newRow("in the head") << 2;
        QTest::newRow("in the pixels") << 4;
    }
    void stopsWhereTheSinkTakesNoMore() {
        QFETCH(int, calls);
        int called = 0;
        QVERIFY(!mission::writePng(noise(300, 200, QImage::Format_RGB32),
                                   [&](const char*, std::size_t) { return called++ < calls; }));
        QCOMPARE(called, calls + 1);
    }

    void noPictureIsNotWritten() { QVERIFY(written(QImage()).isEmpty()); }
};

USAR_TEST(tst_PngWriter)

} // namespace tst_png_writer

#include "tst_png_writer.moc"
