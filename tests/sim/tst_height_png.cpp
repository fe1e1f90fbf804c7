#include "core/sim/world/height_png.h"

#include <QObject>
#include <QTemporaryDir>
#include <QTest>

#include <png.h>

#include "core/base/random.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_height_png {

using usar::doubles::pathOf;
using usar::doubles::readAll;
using usar::doubles::writeAll;
using usar::sim::HeightImage;

namespace {

HeightImage noise(std::size_t columns, std::size_t rows) {
    usar::Random random = usar::seeded(columns, rows);
    HeightImage image{.columns = columns, .rows = rows, .values = {}};
    for (std::size_t i = 0; i < columns * rows; ++i)
        image.values.push_back(static_cast<std::uint16_t>(random()));
    return image;
}

/// A picture of 4 x 4 in one of libpng's simple formats.
void writePicture(const std::filesystem::path& file, png_uint_32 format) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    picture.width = picture.height = 4;
    picture.format = format;
    const std::vector<png_byte> pixels(PNG_IMAGE_SIZE(picture), 77);
    QVERIFY(png_image_write_to_file(&picture, file.c_str(), 0, pixels.data(), 0, nullptr) != 0);
}

} // namespace

class tst_HeightPng : public QObject {
    Q_OBJECT

private slots:
    void everyValueSurvives_data() {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("one post") << 1 << 1;
        QTest::newRow("square") << 65 << 65;
        QTest::newRow("wide") << 33 << 5;
        QTest::newRow("all 65536 values and more") << 300 << 300;
    }
    void everyValueSurvives() {
        QFETCH(int, columns);
        QFETCH(int, rows);
        const HeightImage image = noise(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows));
        QVERIFY(usar::sim::writeHeightPng(image, pathOf(folder_) / "a.png"));
        const auto back = usar::sim::readHeightPng(pathOf(folder_) / "a.png");
        QVERIFY(back);
        QVERIFY(*back == image);
    }

    void equalImagesGiveEqualBytes() {
        QVERIFY(usar::sim::writeHeightPng(noise(40, 40), pathOf(folder_) / "a.png"));
        QVERIFY(usar::sim::writeHeightPng(noise(40, 40), pathOf(folder_) / "b.png"));
        QVERIFY(readAll(pathOf(folder_) / "a.png") == readAll(pathOf(folder_) / "b.png"));
    }

    void refusesOtherPictures_data() {
        QTest::addColumn<int>("format");
        QTest::newRow("8-bit gray") << int{PNG_FORMAT_GRAY};
        QTest::newRow("8-bit color") << int{PNG_FORMAT_RGB};
        QTest::newRow("16-bit gray with alpha") << int{PNG_FORMAT_LINEAR_Y_ALPHA};
        QTest::newRow("16-bit color") << int{PNG_FORMAT_LINEAR_RGB};
    }
    void refusesOtherPictures() {
        QFETCH(int, format);
        writePicture(pathOf(folder_) / "a.png", static_cast<png_uint_32>(format));
        const auto image = usar::sim::readHeightPng(pathOf(folder_) / "a.png");
        QVERIFY(!image);
        QVERIFY(image.error().what.find("16-bit grayscale") != std::string::npos);
        QCOMPARE(image.error().where, (pathOf(folder_) / "a.png").string());
        QVERIFY(!image.error().mend.empty());
    }

    void refusesEveryCutFile() {
        QVERIFY(usar::sim::writeHeightPng(noise(6, 6), pathOf(folder_) / "a.png"));
        const std::string whole = readAll(pathOf(folder_) / "a.png");
        for (std::size_t length = 0; length < whole.size(); ++length) {
            writeAll(pathOf(folder_) / "cut.png", whole.substr(0, length));
            QVERIFY2(!usar::sim::readHeightPng(pathOf(folder_) / "cut.png"), std::to_string(length).c_str());
        }
    }

    void refusesAMissingFile() {
        const auto image = usar::sim::readHeightPng(pathOf(folder_) / "none.png");
        QVERIFY(!image);
        QCOMPARE(image.error().where, (pathOf(folder_) / "none.png").string());
    }

    void saysWhenTheFileCannotBeWritten() {
        const auto written = usar::sim::writeHeightPng(noise(4, 4), pathOf(folder_) / "no" / "such" / "a.png");
        QVERIFY(!written);
        QVERIFY(!written.error().mend.empty());
    }

private:
    QTemporaryDir folder_;
};

USAR_TEST(tst_HeightPng)

} // namespace tst_height_png

#include "tst_height_png.moc"
