// The difference of two maps as the dialog for comparisons shows it.
#include <limits>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/height_difference.h"

namespace tst_height_difference {

using namespace usar;
using namespace usar::widgets;

namespace {

constexpr float nan_m = std::numeric_limits<float>::quiet_NaN();

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s cannot be written", qPrintable(path));
}

/// Writes a map and its summary as a mission does; returns the path of the summary.
QString saved(const QTemporaryDir& folder, const mapping::Raster& raster) {
    const std::vector<char> bytes = mapping::bilBytes(raster);
    write(folder.filePath("run.bil"), QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())));
    write(folder.filePath("run.json"),
          QString(R"({"map": {"columns": %1, "rows": %2, "cell_size_m": %3, "upper_left_center_x_m": %4,
                              "upper_left_center_y_m": %5}})")
              .arg(raster.columns)
              .arg(raster.rows)
              .arg(raster.cell_size_m)
              .arg(raster.upper_left_center_m.x())
              .arg(raster.upper_left_center_m.y())
              .toUtf8());
    return folder.filePath("run.json");
}

const mapping::Raster map{2, 2, 0.25, {-16.125, 20.875}, {1.0f, -2.5f, nan_m, 4.0f}};

} // namespace

class tst_HeightDifference : public QObject {
    Q_OBJECT
private slots:
    void heightsAreReadAsTheyWereSaved() {
        const QTemporaryDir folder;
        const mapping::Raster read = readHeights(saved(folder, map));
        QCOMPARE(read.columns, map.columns);
        QCOMPARE(read.rows, map.rows);
        QCOMPARE(read.upper_left_center_m.y(), 20.875);
        QCOMPARE(read.heights_m[1], -2.5f);
        QVERIFY(std::isnan(read.heights_m[2]));
        QCOMPARE(mapping::differenceOf(read, map)->rms_m, 0.0);
    }

    void whatIsDamagedHasNoHeights() {
        const QTemporaryDir folder;
        const QString path = saved(folder, map);
        write(folder.filePath("run.bil"), "short");
        QVERIFY(readHeights(path).empty());
        QFile::remove(folder.filePath("run.bil"));
        QVERIFY(readHeights(path).empty());
        QVERIFY(readHeights(folder.filePath("none.json")).empty());
    }

    void higherIsOrangeLowerIsBlueEqualIsGray() {
        mapping::Raster other = map;
        other.heights_m = {2.0f, -3.5f, 7.0f, 4.0f};
        const auto difference = mapping::differenceOf(map, other);
        const QImage picture = differencePicture(*difference, 1.0);
        const QColor higher = picture.pixelColor(0, 0), lower = picture.pixelColor(1, 0);
        QVERIFY(higher.red() > higher.blue());
        QVERIFY(lower.blue() > lower.red());
        QCOMPARE(picture.pixelColor(0, 1).alpha(), 0); // Only one map knows it.
        QCOMPARE(picture.pixelColor(1, 1), QColor(128, 128, 128));
        QVERIFY(differenceText(*difference).contains("only in the second 1"));
        QCOMPARE(fullColorOf_m(*mapping::differenceOf(map, map)), 0.05);
    }

    void mapsWithoutASharedCellSaySo() {
        mapping::Raster other = map;
        other.heights_m = {nan_m, nan_m, 7.0f, nan_m};
        QCOMPARE(differenceText(*mapping::differenceOf(map, other)), QString("The maps have no cell in common."));
    }
};

USAR_TEST(tst_HeightDifference)

} // namespace tst_height_difference

#include "tst_height_difference.moc"
