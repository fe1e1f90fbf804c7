#include <cmath>

#include <QPainter>
#include <QTest>

#include "core/mapping/shading.h"
#include "core/mission/files/map_picture.h"
#include "core/mission/files/picture_legend.h"
#include "tests/mission/files/sample_scan.h"
#include "tests/suite/suite.h"

namespace tst_map_picture {

using namespace usar;
using namespace usar::mission;
using agent::MarkKind;

namespace {

/// Pixels of just this color above the legend.
int count(const QImage& picture, const QColor& color, int rows) {
    int found = 0;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < picture.width(); ++x)
            found += picture.pixel(x, y) == color.rgb() ? 1 : 0;
    }
    return found;
}

/// The color of level ground at this fraction of the range.
QColor groundColor(float part) {
    return QColor::fromRgb(mapping::shade(part, {0.0f, 1.0f}, mapping::ColorMap::Color));
}

ScanRecord flatScan(int columns, int rows) {
    ScanRecord record;
    record.level = "flat";
    record.raster.columns = columns;
    record.raster.rows = rows;
    record.raster.cell_size_m = 0.5;
    record.raster.heights_m.assign(std::size_t(columns) * std::size_t(rows), 1.0f);
    return record;
}

} // namespace

class tst_MapPicture : public QObject {
    Q_OBJECT
private slots:
    void smallHolesAreFilledInAndDull() {
        ScanRecord record = flatScan(100, 100);
        const auto colorInTheMiddle = [&record] {
            const QImage picture = mapPicture(record);
            return picture.pixelColor(picture.width() / 2 + 1, picture.width() / 2 + 1);
        };
        const QColor ground = colorInTheMiddle();
        record.raster.heights_m[50 * 100 + 50] = std::nanf("");
        const QColor filled = colorInTheMiddle();
        QCOMPARE(filled.green(), (ground.green() + QColor(unknown_color).green()) / 2);
        QVERIFY(filled != ground);
        for (int row = 48; row < 52; ++row) // A larger hole stays unknown.
            for (int column = 48; column < 52; ++column)
                record.raster.heights_m[std::size_t(row * 100 + column)] = std::nanf("");
        QCOMPARE(colorInTheMiddle(), QColor(unknown_color));
    }

    void smallMapsAreEnlargedUntilLegible_data() {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("width_px");
        QTest::addColumn<int>("map_height_px");
        QTest::newRow("one cell") << 1 << 1 << 600 << 600;
        QTest::newRow("240 x 160") << 240 << 160 << 960 << 640;
        QTest::newRow("large enough") << 800 << 900 << 800 << 900;
        QTest::newRow("a thin strip is not made endless") << 4000 << 10 << 4000 << 10;
        QTest::newRow("an upright strip leaves room for the legend") << 10 << 4000 << 600 << 4000;
        QTest::newRow("huge") << 10000 << 5000 << 8192 << 4096;
    }

    void smallMapsAreEnlargedUntilLegible() {
        QFETCH(int, columns);
        QFETCH(int, rows);
        QFETCH(int, width_px);
        QFETCH(int, map_height_px);
        const QImage picture = mapPicture(flatScan(columns, rows));
        QCOMPARE(picture.width(), width_px);
        QVERIFY(picture.height() > map_height_px);
        QVERIFY(picture.height() < map_height_px + std::max(180, map_height_px / 3));
        QCOMPARE(picture.pixelColor(width_px / 2, map_height_px / 2), groundColor(0.5f));
    }

    void thePictureCanBeGrayLikeTheMap() {
        ScanRecord record = flatScan(40, 40);
        for (std::size_t cell = 0; cell < record.raster.heights_m.size(); ++cell)
            record.raster.heights_m[cell] = static_cast<float>(cell % 40); // A slope: color would be lit.
        const QImage picture = mapPicture(record, {mapping::ColorMap::Gray});
        const mapping::HeightRange range = record.raster.range().value();
        for (int column = 0; column < 40; ++column)
            QCOMPARE(picture.pixel(15 * column + 7, 300),
                     mapping::shade(float(column), range, mapping::ColorMap::Gray));
        /// Pixels of the legend in the dark blue of low ground; a gradient is not exact.
        const auto colored = [](const QImage& image) {
            const QColor low = groundColor(0.1f);
            int found = 0;
            for (int y = 600; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    const QColor color(image.pixel(x, y));
                    found += std::abs(color.red() - low.red()) + std::abs(color.green() - low.green()) +
                                         std::abs(color.blue() - low.blue()) <
                                     12
                                 ? 1
                                 : 0;
                }
            return found;
        };
        QVERIFY2(colored(mapPicture(record)) > 0, "the bar of the legend in color");
        QCOMPARE(colored(picture), 0);
    }

    void theColorsOfThePictureFollowTheRangeOfTheMap_data() {
        QTest::addColumn<mapping::HeightLook>("look");
        QTest::addColumn<mapping::HeightRange>("range");
        const auto gray = mapping::ColorMap::Gray;
        QTest::newRow("whole") << mapping::HeightLook{gray} << mapping::HeightRange{0.0f, 1024.0f};
        QTest::newRow("without the tree") << mapping::HeightLook{gray, {}, true} << mapping::HeightRange{0.0f, 40.0f};
        QTest::newRow("fixed") << mapping::HeightLook{gray, mapping::HeightRange{-10.0f, 50.0f}}
                               << mapping::HeightRange{-10.0f, 50.0f};
    }

    /// One cell of 1600 is high; the others rise from 0 to 39 m.
    void theColorsOfThePictureFollowTheRangeOfTheMap() {
        QFETCH(mapping::HeightLook, look);
        QFETCH(mapping::HeightRange, range);
        ScanRecord record = flatScan(40, 40);
        for (std::size_t cell = 0; cell < record.raster.heights_m.size(); ++cell)
            record.raster.heights_m[cell] = static_cast<float>(cell % 40);
        record.raster.heights_m[0] = 1024.0f; // So that a step is one meter.
        const QImage picture = mapPicture(record, look);
        for (int column = 0; column < 40; ++column)
            QCOMPARE(picture.pixel(15 * column + 7, 300),
                     mapping::shade(float(column), range, mapping::ColorMap::Gray));
    }

    void upIsUpAndRightIsRight() {
        ScanRecord record = flatScan(20, 20);
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column) {   // Level around the corner, so that it is not shaded.
                record.raster.heights_m[row * 20 + column] = 5.0f; // lowest x, highest y
                record.raster.heights_m[(19 - row) * 20 + 19 - column] = 3.0f; // highest x, lowest y
            }
        record.raster.heights_m[19] = NAN; // highest x, highest y
        const QImage picture = mapPicture(record);
        QCOMPARE(picture.pixelColor(3, 3), groundColor(1.0f));
        QCOMPARE(picture.pixelColor(590, 590), groundColor(0.5f));
        QCOMPARE(picture.pixelColor(300, 300), groundColor(0.0f));
        QCOMPARE(picture.pixelColor(590, 3), QColor(0x2c3340));
    }

    void marksHaveTheThesisColors_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("hue_low");
        QTest::addColumn<int>("hue_high");
        QTest::newRow("path is green") << int(MarkKind::Path) << 100 << 150;
        QTest::newRow("diversion is blue") << int(MarkKind::Diversion) << 205 << 250;
        QTest::newRow("low risk is orange") << int(MarkKind::LowRisk) << 20 << 42;
        QTest::newRow("high risk is red") << int(MarkKind::HighRisk) << 340 << 368;
        QTest::newRow("recharge is yellow") << int(MarkKind::Recharge) << 48 << 62;
        QTest::newRow("landing is violet") << int(MarkKind::Landing) << 270 << 300;
    }

    void marksHaveTheThesisColors() {
        QFETCH(int, kind);
        QFETCH(int, hue_low);
        QFETCH(int, hue_high);
        const QColor color = QColor(usar::agent::styleOf(MarkKind(kind)).rgb);
        const int hue = color.hue() < 10 ? color.hue() + 360 : color.hue();
        QVERIFY2(hue >= hue_low && hue <= hue_high, qPrintable(QString::number(color.hue())));
        ScanRecord record = flatScan(100, 100);
        const int before = count(mapPicture(record), color, 600);
        record.marks.push_back({MarkKind(kind), {25, -25, 0}, {}, {}});
        QCOMPARE(before, 0);
        QVERIFY(count(mapPicture(record), color, 600) >= 5);
    }

    /// The same shapes as in the window, where color is never the only difference either.
    void marksHaveTheShapesOfTheWindow() {
        const auto inked = [](MarkKind kind, const QPoint& off_center) {
            QImage picture(80, 80, QImage::Format_RGB32);
            picture.fill(Qt::gray);
            QPainter painter(&picture);
            drawMark(painter, kind, {40, 40}, 10.0);
            painter.end();
            return picture.pixelColor(QPoint(40, 40) + off_center) == QColor(agent::styleOf(kind).rgb);
        };
        QVERIFY(inked(MarkKind::HighRisk, {-11, 11}) && !inked(MarkKind::HighRisk, {-11, -8}));   // a triangle
        QVERIFY(inked(MarkKind::Diversion, {0, -14}) && !inked(MarkKind::Diversion, {-10, -10})); // a diamond
        QVERIFY(inked(MarkKind::LowRisk, {-8, -8}) && !inked(MarkKind::LowRisk, {0, -16}));       // a disc
        QVERIFY(inked(MarkKind::Landing, {0, -26}) && !inked(MarkKind::Landing, {0, 0}));         // a ring
    }

    void marksLieWhereTheyHappened() {
        ScanRecord record = flatScan(100, 100); // x -0.25 .. 49.75, y 0.25 .. -49.75; 12 pixels a metre
        record.marks.push_back({MarkKind::Recharge, {9.75, -29.75, 6}, {}, {}});
        record.path_m = {{39.75, -9.75, 6}};
        const QImage picture = mapPicture(record);
        QCOMPARE(picture.pixelColor(120, 360), QColor(usar::agent::styleOf(MarkKind::Recharge).rgb));
        QCOMPARE(picture.pixelColor(480, 120), QColor(usar::agent::styleOf(MarkKind::Path).rgb));
    }

    void theWayHomeOutsideTheMapIsShown() {
        ScanRecord record = flatScan(100, 100);
        record.marks.push_back({MarkKind::Recharge, {-20, -25, 0}, {}, {}});
        const QImage picture = mapPicture(record);
        QVERIFY(picture.width() > 800);
        QVERIFY(count(picture, QColor(usar::agent::styleOf(MarkKind::Recharge).rgb), 600) >= 5);
    }

    void garbledPositionsDoNotStretchThePicture() {
        ScanRecord record = flatScan(100, 100);
        const QSize size = mapPicture(record).size();
        record.marks.push_back({MarkKind::Landing, {1e9, 0, 0}, {}, {}});
        record.path_m = {{qQNaN(), 0, 0}, {0, -1e12, 0}, {25, qInf(), 0}};
        QCOMPARE(mapPicture(record).size(), size);
    }

    void anEmptyScanHasNoPicture() {
        QVERIFY(mapPicture({}).isNull());
        QVERIFY(heightImage({}).isNull());
    }

    void metadataIsInTheTextKeys() {
        const QImage picture = mapPicture(sampleScan(50));
        QCOMPARE(picture.text("level"), QString("tall_test"));
        QCOMPARE(picture.text("robot"), QString("R1"));
        QCOMPARE(picture.text("behavior"), QString("airrobot/cpp"));
        QCOMPARE(picture.text("cell_size_m"), QString("0.25"));
        QCOMPARE(picture.text("pixels_per_m"), QString("48"));
        QVERIFY(picture.text("minimum_m").toDouble() < picture.text("maximum_m").toDouble());
    }

    void scaleBarIsARoundLengthThatFits_data() {
        QTest::addColumn<double>("pixels_per_m");
        QTest::addColumn<double>("room_px");
        QTest::addColumn<double>("length_m");
        QTest::newRow("quick scan") << 16.0 << 240.0 << 10.0;
        QTest::newRow("tall test") << 4.0 << 200.0 << 50.0;
        QTest::newRow("a kilometre") << 4.0 << 1000.0 << 200.0;
        QTest::newRow("a room") << 400.0 << 150.0 << 0.2;
        QTest::newRow("exactly") << 10.0 << 100.0 << 10.0;
    }

    void scaleBarIsARoundLengthThatFits() {
        QFETCH(double, pixels_per_m);
        QFETCH(double, room_px);
        QFETCH(double, length_m);
        QVERIFY(std::abs(scaleBarLength_m(pixels_per_m, room_px) - length_m) < 1e-9);
    }

    void heightImageGivesTheHeightsBack() {
        const mapping::Raster raster = sampleScan(80).raster;
        const QImage image = heightImage(raster);
        QCOMPARE(image.format(), QImage::Format_Grayscale16);
        QCOMPARE(image.size(), QSize(80, 80));
        const double scale_m = image.text("height_scale_m").toDouble();
        const double offset_m = image.text("height_offset_m").toDouble();
        int highest = 0, lowest = 65535;
        for (int y = 0; y < 80; ++y) {
            const auto* row = reinterpret_cast<const quint16*>(image.constScanLine(y));
            for (int x = 0; x < 80; ++x) {
                const float height_m = raster.heights_m[std::size_t(y * 80 + x)];
                QCOMPARE(row[x] == 0, std::isnan(height_m));
                if (row[x] == 0)
                    continue;
                QVERIFY(std::abs(offset_m + scale_m * row[x] - double(height_m)) <= scale_m * 0.51);
                highest = std::max(highest, int(row[x]));
                lowest = std::min(lowest, int(row[x]));
            }
        }
        QCOMPARE(lowest, 1);
        QCOMPARE(highest, 65535);
    }

    void levelGroundSurvivesTheHeightImage() {
        const QImage image = heightImage(flatScan(3, 2).raster);
        QCOMPARE(int(reinterpret_cast<const quint16*>(image.constScanLine(1))[2]), 1);
        QCOMPARE(image.text("height_offset_m").toDouble() + image.text("height_scale_m").toDouble(), 1.0);
    }

    void theLegendAloneIsThatBelowThePicture() {
        const ScanRecord record = sampleScan(240);
        const QImage picture = mapPicture(record), legend = legendPicture(record);
        QCOMPARE(legend.width(), picture.width());
        QVERIFY(legend.height() > 60 && legend.height() < picture.height() / 2);
        const int top = picture.height() - legend.height();
        int others = 0; // an edge may be smoothed in another way at another height
        for (int y = 0; y < legend.height(); ++y)
            for (int x = 0; x < legend.width(); ++x) {
                const QColor here(legend.pixel(x, y)), there(picture.pixel(x, top + y));
                others += std::abs(here.red() - there.red()) + std::abs(here.green() - there.green()) +
                                      std::abs(here.blue() - there.blue()) >
                                  12
                              ? 1
                              : 0;
            }
        QVERIFY2(others * 1000 < legend.width() * legend.height(), qPrintable(QString::number(others)));
        for (const char* key : {"level", "robot", "cell_size_m", "pixels_per_m"})
            QCOMPARE(legend.text(key), picture.text(key));
        QVERIFY(count(legend, QColor(agent::styleOf(MarkKind::HighRisk).rgb), legend.height()) > 0);
        QVERIFY(legendPicture(ScanRecord()).isNull());
    }

    void drawsASampleToLookAt() {
        const QImage picture = mapPicture(sampleScan(240));
        QVERIFY(picture.save(USAR_BINARY_DIR "/sample_picture.png"));
        for (const MarkKind kind : {MarkKind::Path, MarkKind::Diversion, MarkKind::LowRisk, MarkKind::HighRisk,
                                    MarkKind::Recharge, MarkKind::Landing, MarkKind::GoalGivenUp})
            QVERIFY(count(picture, QColor(usar::agent::styleOf(kind).rgb), picture.height()) >
                    count(picture, QColor(usar::agent::styleOf(kind).rgb), 720)); // on the map and again in the legend
    }
};

USAR_TEST(tst_MapPicture)

} // namespace tst_map_picture

#include "tst_map_picture.moc"
