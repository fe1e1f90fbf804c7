#include <QTest>

#include <cmath>
#include <limits>
#include <memory>
#include <stop_token>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include "core/mission/files/map_formats.h"
#include "tests/mission/files/other_programs.h"
#include "tests/mission/files/sample_scan.h"
#include "tests/suite/suite.h"

namespace tst_map_formats {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

FormatList formats(const QString& text) {
    return readFormatList(text, "--formats").value_or(FormatList{});
}

ScanRecord recordOf(const mapping::Raster& raster) {
    ScanRecord record;
    record.raster = raster;
    return record;
}

/// What GDAL reads at this cell.
double heightAt(const QString& file, int column, int row) {
    return run("gdallocationinfo", {"-valonly", file, QString::number(column), QString::number(row)})
        .trimmed()
        .toDouble();
}

} // namespace

class tst_MapFormats : public QObject {
    Q_OBJECT
private slots:
    void listsAreReadInTheirOrder_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QStringList>("ids");
        QTest::newRow("one") << "tif" << QStringList{"tif"};
        QTest::newRow("two") << "asc,tif" << QStringList{"asc", "tif"};
        QTest::newRow("twice the same") << "tif,tif" << QStringList{"tif"};
        QTest::newRow("with spaces and capitals") << " TIF , asc" << QStringList{"tif", "asc"};
    }

    void listsAreReadInTheirOrder() {
        QFETCH(QString, text);
        QStringList ids;
        for (const MapFormat* format : formats(text))
            ids << format->id;
        QTEST(ids, "ids");
    }

    void wrongListsNameTheFormatsThatThereAre_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("unknown")
            << "tif,shp"
            << "--export tif,shp: there is no format named shp. Formats are tif, asc, geojson, ply, las;";
        QTest::newRow("empty") << ""
                               << "the name of a format is missing";
        QTest::newRow("a comma too many") << "tif,"
                                          << "the name of a format is missing";
    }

    void wrongListsNameTheFormatsThatThereAre() {
        QFETCH(QString, text);
        QFETCH(QString, words);
        const auto list = readFormatList(text, "--export");
        QVERIFY(!list);
        const QString message = QString::fromStdString(list.error().text());
        QVERIFY2(message.contains(words), qPrintable(message));
    }

    void theHelpHasASentenceForEachFormat() {
        const QStringList notes = formatNotes();
        QCOMPARE(std::size_t(notes.size()), mapFormats().size());
        for (qsizetype i = 0; i < notes.size(); ++i)
            QVERIFY2(notes[i].startsWith(QString(mapFormats()[std::size_t(i)].id) + ": "), qPrintable(notes[i]));
    }

    void gdalReadsTheGrids_data() {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("driver");
        QTest::addColumn<int>("side");
        QTest::newRow("GeoTIFF of one tile") << "tif"
                                             << "GTiff" << 64;
        QTest::newRow("GeoTIFF of just one tile") << "tif"
                                                  << "GTiff" << 256;
        QTest::newRow("GeoTIFF of four tiles") << "tif"
                                               << "GTiff" << 300;
        QTest::newRow("ASCII grid") << "asc"
                                    << "AAIGrid" << 64;
    }

    void gdalReadsTheGrids() {
        QFETCH(QString, id);
        QFETCH(int, side);
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(side, 0.5);
        const auto files = exportMap(record, formats(id), folder.path());
        QVERIFY2(files, files ? "" : files.error().text().c_str());
        QCOMPARE(files->size(), 1);
        const QJsonObject info = runForJson("gdalinfo", {"-json", "-stats", files->first()});
        QTEST(info["driverShortName"].toString(), "driver");
        QCOMPARE(info["size"].toArray(), (QJsonArray{side, side}));
        QCOMPARE(info["geoTransform"].toArray(), (QJsonArray{-side / 4.0, 0.5, 0, side / 4.0, 0, -0.5}));
        const QJsonObject band = info["bands"].toArray()[0].toObject();
        QCOMPARE(band["type"].toString(), QString("Float32"));
        QCOMPARE(band["noDataValue"].toDouble(), -9999.0);
        const mapping::HeightRange range = record.raster.range().value();
        QVERIFY(std::abs(band["minimum"].toDouble() - double(range.minimum_m)) < 1e-3);
        QVERIFY(std::abs(band["maximum"].toDouble() - double(range.maximum_m)) < 1e-3);
        for (const auto& [column, row] : {std::pair(0, 0), std::pair(40, 10), std::pair(side - 1, side - 1)}) {
            const float height_m = record.raster.heights_m[std::size_t(row * side + column)];
            QVERIFY(std::abs(heightAt(files->first(), column, row) - double(height_m)) < 1e-4);
        }
        QCOMPARE(heightAt(files->first(), 0, side - 1), -9999.0);
    }

    void theGeoTiffIsTiledAndInALocalFrame() {
        QTemporaryDir folder;
        const auto files = exportMap(sampleScan(300), formats("tif"), folder.path());
        QVERIFY(files);
        const QJsonObject info = runForJson("gdalinfo", {"-json", files->first()});
        QCOMPARE(info["bands"].toArray()[0].toObject()["block"].toArray(), (QJsonArray{256, 256}));
        QCOMPARE(info["metadata"].toObject()[""].toObject()["AREA_OR_POINT"].toString(), QString("Area"));
        const QString frame = info["coordinateSystem"].toObject()["wkt"].toString();
        QVERIFY2(frame.contains("ENGCRS[\"map frame\"") && frame.contains("LENGTHUNIT[\"metre\",1"), qPrintable(frame));
    }

    void gdalReadsTheContours() {
        QTemporaryDir folder;
        const auto files = exportMap(sampleScan(64, 0.5), formats("geojson"), folder.path());
        QVERIFY(files);
        const QByteArray info = run("ogrinfo", {"-al", "-so", files->first()});
        for (const char* const words :
             {"using driver `GeoJSON'", "Geometry: Line String", "ENGCRS[\"map frame\"", "elevation_m: Real"})
            QVERIFY2(info.contains(words), info);
        const QByteArray count = info.mid(info.indexOf("Feature Count: ") + 15);
        QVERIFY2(count.left(count.indexOf('\n')).toInt() > 10, info);
        const QByteArray high = run("ogrinfo", {"-al", "-so", "-where", "elevation_m > 3.5", files->first()});
        QVERIFY2(!high.contains("Feature Count: 0\n"), high);
    }

    void contoursOfTheSmallestMapsHaveNoFeatures_data() {
        QTest::addColumn<mapping::Raster>("raster");
        QTest::newRow("one cell") << mapping::Raster{1, 1, 0.25, {3.5, -2.5}, {7.5f}};
        QTest::newRow("flat") << mapping::Raster{2, 2, 0.25, {3.5, -2.5}, {7.5f, 7.5f, 7.5f, 7.5f}};
        QTest::newRow("holes everywhere") << mapping::Raster{2, 2, 0.25, {0.0, 0.0}, {0.0f, unknown, unknown, 9.0f}};
    }

    void contoursOfTheSmallestMapsHaveNoFeatures() {
        QFETCH(mapping::Raster, raster);
        QTemporaryDir folder;
        const auto files = exportMap(recordOf(raster), formats("geojson"), folder.path());
        QVERIFY(files);
        QFile file(files->first());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(json["type"].toString(), QString("FeatureCollection"));
        QVERIFY(json["features"].isArray() && json["features"].toArray().isEmpty());
    }

    void pointsNeedTheScans() {
        QTemporaryDir folder;
        ScanRecord record = sampleScan(5);
        QVERIFY(needPoints(formats("tif,ply")) && !needPoints(formats("tif,geojson")));
        QCOMPARE(withoutPoints(formats("las,tif,ply")), formats("tif"));
        const auto refused = exportMap(record, formats("tif,las"), folder.path());
        QVERIFY(!refused);
        QVERIFY2(refused.error().text().starts_with("las: there are no points, only heights. Export it from the "),
                 refused.error().text().c_str());
        QVERIFY(QDir(folder.path()).isEmpty());
        mapping::KeptScan scan;
        scan.time = Seconds{3.0};
        scan.scanner_in_map.position_m = {1.0, 2.0, 3.0};
        scan.ranges_m = {5.0f, 20.0f};
        record.scans = std::make_shared<const std::vector<mapping::KeptScan>>(3, scan);
        record.far_rasters = {{1, 2, 0.5, {9000.25, 50.25}, {7.0f, 8.0f}}};
        const auto files = exportMap(record, formats("ply,las"), folder.path());
        QVERIFY2(files, files ? "" : files.error().text().c_str());
        QCOMPARE(files->size(), 2); // Points are not divided into near and far ones.
        QCOMPARE(QFileInfo(ending(*files, ".las")).size(), 473 + 3 * 32);
        QFile ply(ending(*files, ".ply"));
        QVERIFY(ply.open(QIODevice::ReadOnly));
        QVERIFY(ply.readAll().contains("element vertex 3\n"));
    }

    void gdalShadesTheGeoTiff() {
        QTemporaryDir folder;
        const auto files = exportMap(sampleScan(64, 0.5), formats("tif"), folder.path());
        QVERIFY(files);
        const QString shaded = folder.filePath("shaded.tif");
        run("gdaldem", {"hillshade", "-q", files->first(), shaded});
        const QJsonObject info = runForJson("gdalinfo", {"-json", "-stats", shaded});
        QCOMPARE(info["size"].toArray(), (QJsonArray{64, 64}));
        const QJsonObject band = info["bands"].toArray()[0].toObject();
        QVERIFY(band["maximum"].toDouble() - band["minimum"].toDouble() > 50.0); // Trees and hills have slopes.
        QCOMPARE(heightAt(shaded, 0, 63), 0.0);                                  // A hole stays one.
    }

    void smallAndHollowMapsAreExported_data() {
        QTest::addColumn<mapping::Raster>("raster");
        QTest::newRow("one cell") << mapping::Raster{1, 1, 0.25, {3.5, -2.5}, {7.5f}};
        QTest::newRow("one row") << mapping::Raster{3, 1, 0.25, {0.0, 0.0}, {7.5f, unknown, 8.0f}};
        QTest::newRow("one column with a hole") << mapping::Raster{1, 3, 0.25, {0.0, 0.0}, {7.5f, unknown, 8.0f}};
        QTest::newRow("unknown in the first cell") << mapping::Raster{2, 2, 0.25, {0.0, 0.0}, {unknown, 1.f, 2.f, 3.f}};
    }

    void smallAndHollowMapsAreExported() {
        QFETCH(mapping::Raster, raster);
        QTemporaryDir folder;
        const auto files = exportMap(recordOf(raster), formats("tif,asc"), folder.path());
        QVERIFY2(files, files ? "" : files.error().text().c_str());
        for (const QString& file : *files)
            for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
                const int column = int(i) % int(raster.columns), row = int(i) / int(raster.columns);
                const double height_m = double(raster.heights_m[i]);
                QCOMPARE(heightAt(file, column, row), std::isnan(height_m) ? -9999.0 : height_m);
            }
    }

    void farPartsAreExportedToo() {
        QTemporaryDir folder;
        ScanRecord record = sampleScan(20);
        record.far_rasters = {{1, 2, 0.5, {9000.25, 50.25}, {7.0f, 8.0f}}};
        const auto files = exportMap(record, formats("tif,asc"), folder.path());
        QVERIFY(files);
        QCOMPARE(files->size(), 4);
        for (const char* const end : {"_far1.tif", "_far1.asc"})
            QCOMPARE(
                run("gdallocationinfo", {"-valonly", "-geoloc", ending(*files, end), "9000.25", "49.75"}).trimmed(),
                QByteArray("8"));
    }

    void filesGetAFreeNumberOrTheGivenStem() {
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(5);
        const auto first = exportMap(record, formats("tif"), folder.path());
        const auto second = exportMap(record, formats("tif"), folder.path());
        const auto named = exportMap(record, formats("tif"), folder.filePath("new/deeper"), "flight");
        QVERIFY(first && second && named);
        QVERIFY(first->first().endsWith("/USAR_Scan_tall-test_R1_001.tif"));
        QVERIFY(second->first().endsWith("/USAR_Scan_tall-test_R1_002.tif"));
        QCOMPARE(*named, QStringList{folder.filePath("new/deeper/flight.tif")});
    }

    void refusalsSayWhyAndLeaveNothing_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("side");
        QTest::addColumn<QString>("words");
        QTest::newRow("a file of this name") << "taken" << 5 << "left alone";
        QTest::newRow("an empty map") << "new" << 0 << "nothing was scanned";
        QTest::newRow("a folder below a file") << "taken/flight.asc/deeper" << 5 << "cannot create the folder";
        QTest::newRow("a folder where nothing can be written") << "/proc" << 5 << "/proc: cannot write into the folder";
    }

    void refusalsSayWhyAndLeaveNothing() {
        QFETCH(QString, folder);
        QFETCH(int, side);
        QFETCH(QString, words);
        QTemporaryDir place;
        QVERIFY(QDir(place.path()).mkpath("taken"));
        QFile taken(place.filePath("taken/flight.asc"));
        QVERIFY(taken.open(QIODevice::WriteOnly) && taken.write("mine") == 4);
        taken.close();
        const auto files =
            exportMap(sampleScan(side), formats("tif,asc"), QDir(place.path()).filePath(folder), "flight");
        QVERIFY(!files);
        const QString message = QString::fromStdString(files.error().text());
        QVERIFY2(message.contains(words), qPrintable(message));
        QCOMPARE(QDir(place.filePath("taken")).entryList(QDir::Files | QDir::Hidden), QStringList{"flight.asc"});
        QVERIFY(taken.open(QIODevice::ReadOnly));
        QCOMPARE(taken.readAll(), QByteArray("mine"));
    }

    void aCancelledExportLeavesNothing() {
        QTemporaryDir folder;
        std::stop_source user;
        user.request_stop();
        const auto files = exportMap(sampleScan(5), formats("tif"), folder.path(), {}, user.get_token());
        QVERIFY(!files && files.error().what.find("cancelled") != std::string::npos);
        QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
    }
};

USAR_TEST(tst_MapFormats)

} // namespace tst_map_formats

#include "tst_map_formats.moc"
