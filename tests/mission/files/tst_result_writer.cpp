#include <QTest>

#include <cmath>
#include <future>
#include <stop_token>
#include <vector>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QImageReader>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLockFile>
#include <QTemporaryDir>

#include "core/mission/files/result_writer.h"
#include "tests/mission/files/other_programs.h"
#include "tests/mission/files/sample_scan.h"
#include "tests/suite/suite.h"

namespace tst_result_writer {

using namespace usar;
using namespace usar::mission;

namespace {

QJsonObject readJson(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

} // namespace

class tst_ResultWriter : public QObject {
    Q_OBJECT
private slots:
    void leavesAllFilesAndNothingElse() {
        QTemporaryDir folder;
        const auto files = writeResults(sampleScan(60), {}, folder.filePath("new/deeper"));
        QVERIFY2(files.has_value(), files ? "" : files.error().text().c_str());
        QStringList names;
        for (const QString& file : *files)
            names << QFileInfo(file).fileName();
        names.sort();
        const QString stem = "USAR_Scan_tall-test_R1_001";
        QStringList expected{stem + ".bil",         stem + ".hdr",        stem + ".json",       stem + ".asc",
                             stem + ".xyz",         stem + "_height.pgw", stem + "_height.png", stem + "_legend.png",
                             stem + "_picture.png", stem + "_3d.png"};
        expected.sort();
        QCOMPARE(names, expected);
        QStringList found =
            QDir(folder.filePath("new/deeper")).entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot);
        found.sort();
        QCOMPARE(found, expected);
    }

    void addsThePathAndTheDeviationOfAnAdjustedMap() {
        QTemporaryDir folder;
        ScanRecord record = sampleScan(30);
        record.adjustment =
            MapAdjustment{.verdict = mapping::AdjustmentVerdict::Adjusted,
                          .path = {{Seconds(1.5), Vec3(1.0, 2.0, 3.0), Vec3(1.25, 2.0, 2.5), Vec3(0.1, 0.2, 0.05)}},
                          .deviation = record.raster};
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY(files.has_value());
        QFile path(ending(*files, "_path.csv"));
        QVERIFY(path.open(QIODevice::ReadOnly));
        QCOMPARE(path.readLine(), QByteArray("time_s,estimated_x_m,estimated_y_m,estimated_z_m,x_m,y_m,z_m,"
                                             "sigma_x_m,sigma_y_m,sigma_z_m\n"));
        QCOMPARE(path.readAll(), QByteArray("1.50,1.000,2.000,3.000,1.250,2.000,2.500,0.100,0.200,0.050\n"));
        QCOMPARE(QFileInfo(ending(*files, "_deviation.flt")).size(), qint64(record.raster.heights_m.size()) * 4);
        QVERIFY(!ending(*files, "_deviation.hdr").isEmpty());
    }

    void addsHeightsWithoutSmallHolesAndAMask() {
        QTemporaryDir folder;
        ScanRecord record = sampleScan(30);
        const std::size_t hole = 10 * 30 + 15;
        record.raster.heights_m[hole] = std::nanf("");
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY(files.has_value());
        const auto valueAt = [&](const char* file) {
            QFile raw(ending(*files, file));
            mapping::Raster raster = record.raster;
            const QByteArray bytes = raw.open(QIODevice::ReadOnly) ? raw.readAll() : QByteArray();
            return mapping::takeBilBytes(raster, {bytes.data(), std::size_t(bytes.size())}) ? raster.heights_m[hole]
                                                                                            : -1.0f;
        };
        QVERIFY(std::isnan(valueAt("_001.bil")));
        QVERIFY(std::abs(valueAt("_filled.flt") - record.raster.heights_m[hole + 1]) < 1.0f);
        QCOMPARE(valueAt("_filled_mask.flt"), 1.0f);
        QVERIFY(!ending(*files, "_filled.hdr").isEmpty() && !ending(*files, "_filled_mask.hdr").isEmpty());
    }

    void gdalOpensTheRawHeights() {
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(64, 0.5);
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY(files.has_value());
        const QString raw = ending(*files, ".bil");
        const QJsonObject info = runForJson("gdalinfo", {"-json", "-stats", raw});
        QCOMPARE(info["driverShortName"].toString(), QString("EHdr"));
        QCOMPARE(info["size"].toArray(), (QJsonArray{64, 64}));
        QCOMPARE(info["geoTransform"].toArray(), (QJsonArray{-16, 0.5, 0, 16, 0, -0.5}));
        const QJsonObject band = info["bands"].toArray()[0].toObject();
        QCOMPARE(band["type"].toString(), QString("Float32"));
        QCOMPARE(band["noDataValue"].toDouble(), -9999.0);
        const mapping::HeightRange range = record.raster.range().value();
        QVERIFY(std::abs(band["minimum"].toDouble() - double(range.minimum_m)) < 1e-3);
        QVERIFY(std::abs(band["maximum"].toDouble() - double(range.maximum_m)) < 1e-3);
        const double value = run("gdallocationinfo", {"-valonly", raw, "40", "10"}).trimmed().toDouble();
        QVERIFY(std::abs(value - double(record.raster.heights_m[10 * 64 + 40])) < 1e-4);
        QCOMPARE(run("gdallocationinfo", {"-valonly", raw, "0", "63"}).trimmed(), QByteArray("-9999"));
    }

    void gdalOpensTheAsciiGrid() {
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(64, 0.5);
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY(files.has_value());
        const QString grid = ending(*files, ".asc");
        const QJsonObject info = runForJson("gdalinfo", {"-json", grid});
        QCOMPARE(info["driverShortName"].toString(), QString("AAIGrid"));
        QCOMPARE(info["geoTransform"].toArray(), (QJsonArray{-16, 0.5, 0, 16, 0, -0.5}));
        QCOMPARE(info["bands"].toArray()[0].toObject()["noDataValue"].toDouble(), -9999.0);
        const double value = run("gdallocationinfo", {"-valonly", grid, "40", "10"}).trimmed().toDouble();
        QVERIFY(std::abs(value - double(record.raster.heights_m[10 * 64 + 40])) < 1e-4);
        QCOMPARE(run("gdallocationinfo", {"-valonly", grid, "0", "63"}).trimmed(), QByteArray("-9999"));
    }

    void writesTheFormatsThatAreAskedForBesides() {
        QTemporaryDir folder;
        const FormatList formats = *readFormatList("tif,asc", "--export");
        const auto files = writeResults(sampleScan(20), {}, folder.path(), {}, {}, formats);
        QVERIFY(files.has_value());
        QCOMPARE(files->size(), 11); // The grid as text is there anyway.
        QVERIFY(!ending(*files, "_R1_001.tif").isEmpty());
        QVERIFY(readJson(ending(*files, ".json"))["files"].toArray().contains("USAR_Scan_tall-test_R1_001.tif"));
    }

    void aHugeMapIsWrittenAsTextOnlyIfAskedFor() {
        QTemporaryDir folder;
        ScanRecord record = sampleScan(64, 0.5);
        const std::int64_t side = 2049; // One row more than is worth it.
        record.raster = {side, side, 0.5, Vec2::Zero(), std::vector<float>(std::size_t(side * side), 1.0f)};
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY(files.has_value());
        QVERIFY(ending(*files, ".asc").isEmpty() && ending(*files, ".xyz").isEmpty());
        QVERIFY(!ending(*files, ".bil").isEmpty());
        const auto asked = writeResults(record, {}, folder.path(), {}, {}, *readFormatList("asc", "--export"));
        QVERIFY(asked.has_value() && !ending(*asked, ".asc").isEmpty() && ending(*asked, ".xyz").isEmpty());
    }

    void farPartsAreSavedAsRawHeightsOfTheirOwn() {
        QTemporaryDir folder;
        ScanRecord record = sampleScan(64, 0.5);
        QCOMPARE(farPartsNotice(record), std::string());
        record.far_rasters = {{1, 2, 0.5, {9000.25, 50.25}, {7.0f, 8.0f}}, {1, 1, 0.5, {-9000.25, 50.25}, {9.0f}}};
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY(files.has_value());
        QVERIFY(!ending(*files, "_far1.hdr").isEmpty() && !ending(*files, "_far2.hdr").isEmpty());
        QCOMPARE(
            run("gdallocationinfo", {"-valonly", "-geoloc", ending(*files, "_far1.bil"), "9000.25", "49.75"}).trimmed(),
            QByteArray("8"));
        const QJsonObject map = readJson(ending(*files, ".json"))["map"].toObject();
        QCOMPARE(map["far_parts"].toInt(), 2);
        QCOMPARE(map["far_known_cells"].toInt(), 3);
        const QString notice = QString::fromStdString(farPartsNotice(record));
        QVERIFY2(notice.contains("the middle 32 m x 32 m: 3 cells in 2 other places") &&
                     notice.contains("larger cells"),
                 qPrintable(notice));
        QVERIFY(!notice.contains("not saved"));
    }

    void gdalPlacesTheHeightImage() {
        QTemporaryDir folder;
        const auto files = writeResults(sampleScan(64, 0.5), {}, folder.path());
        QVERIFY(files.has_value());
        const QJsonObject info = runForJson("gdalinfo", {"-json", ending(*files, "_height.png")});
        QCOMPARE(info["geoTransform"].toArray(), (QJsonArray{-16, 0.5, 0, 16, 0, -0.5}));
        QCOMPARE(info["bands"].toArray()[0].toObject()["type"].toString(), QString("UInt16"));
    }

    void pngcheckIsContent_data() {
        QTest::addColumn<QString>("suffix");
        QTest::addColumn<QStringList>("texts");
        QTest::newRow("picture") << "_picture.png"
                                 << QStringList{"level", "robot", "behavior", "cell_size_m", "axes", "units"};
        QTest::newRow("legend") << "_legend.png" << QStringList{"level", "robot", "cell_size_m", "pixels_per_m"};
        QTest::newRow("in perspective") << "_3d.png" << QStringList{"level", "robot", "cell_size_m", "seen_from"};
        QTest::newRow("heights") << "_height.png"
                                 << QStringList{"height_scale_m", "height_offset_m", "upper_left_center_x_m", "robot"};
    }

    void pngcheckIsContent() {
        QFETCH(QString, suffix);
        QFETCH(QStringList, texts);
        QTemporaryDir folder;
        const auto files = writeResults(sampleScan(100), {}, folder.path());
        QVERIFY(files.has_value());
        const QByteArray output = run("pngcheck", {"-t", ending(*files, suffix)});
        QVERIFY2(output.contains("OK:"), output);
        for (const QString& text : texts)
            QVERIFY2(output.contains(text.toLatin1()), qPrintable(text + " is missing in " + output));
        const QImage image(ending(*files, suffix));
        QCOMPARE(image.text("robot"), QString("R1"));
    }

    void theSummaryIsKeptAndTheMapDescribed() {
        QTemporaryDir folder;
        const QJsonObject summary{{"success", true}, {"duration_s", 12.5}};
        const auto files = writeResults(sampleScan(60, 0.5), summary, folder.path());
        QVERIFY(files.has_value());
        const QJsonObject json = readJson(ending(*files, ".json"));
        QCOMPARE(json["success"].toBool(), true);
        QCOMPARE(json["duration_s"].toDouble(), 12.5);
        const QJsonObject map = json["map"].toObject();
        QCOMPARE(map["cell_size_m"].toDouble(), 0.5);
        QCOMPARE(map["upper_left_center_x_m"].toDouble(), -14.75);
        QCOMPARE(map["upper_left_center_y_m"].toDouble(), 14.75);
        QCOMPARE(map["columns"].toInt(), 60);
        QCOMPARE(map["no_data_m"].toDouble(), -9999.0);
        QCOMPARE(map["known_cells"].toInt(), 60 * 60 - 12 * 11);
        QCOMPARE(map["robot"].toString(), QString("R1"));
        QCOMPARE(map["area"].toObject()["width"].toDouble(), 30.0);
        QCOMPARE(json["files"].toArray().size(), 10);
        QVERIFY(json["files"].toArray().contains("USAR_Scan_tall-test_R1_001_legend.png"));
        QCOMPARE(json["marks"].toArray().size(), 21); // without the path's
        QCOMPARE(json["marks"].toArray()[0].toObject()["kind"].toString(), QString("diversion"));
    }

    void neverOverwritesAnOlderScan() {
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(20);
        QStringList all;
        for (int i = 0; i < 3; ++i)
            all += writeResults(record, {}, folder.path()).value();
        all.removeDuplicates();
        QCOMPARE(all.size(), 30);
        // A lone leftover blocks its number, whatever kind of file it is.
        QFile other(folder.filePath("USAR_Scan_tall-test_R1_004_picture.png"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.close();
        QVERIFY(writeResults(record, {}, folder.path()).value()[0].contains("_R1_005"));
        QCOMPARE(QFileInfo(other.fileName()).size(), 0);
    }

    void scansSavedAtTheSameTimeGetNumbersOfTheirOwn() {
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(40);
        std::vector<std::future<Result<QStringList>>> runs;
        for (int i = 0; i < 6; ++i)
            runs.push_back(std::async(std::launch::async, [&] { return writeResults(record, {}, folder.path()); }));
        QStringList all;
        for (auto& run : runs)
            all += run.get().value_or(QStringList{});
        all.removeDuplicates();
        QCOMPARE(all.size(), 60);
    }

    void aCancelledSaveLeavesNothing_data() {
        QTest::addColumn<QString>("seen"); // the file whose appearance makes the user cancel
        QTest::newRow("before it begins") << "";
        QTest::newRow("with the raw heights written") << "*.hdr";
        QTest::newRow("with the text written") << "*.xyz";
        QTest::newRow("with the height image written") << "*_height.pgw";
    }

    void aCancelledSaveLeavesNothing() {
        QFETCH(QString, seen);
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(2000);
        std::stop_source user;
        if (seen.isEmpty())
            user.request_stop();
        auto saving = std::async(std::launch::async, [&] {
            return writeResults(record, {}, folder.path(), mapping::HeightLook{}, user.get_token());
        });
        const QDir files(folder.path());
        QTRY_VERIFY_WITH_TIMEOUT(seen.isEmpty() || !files.entryList({seen}, QDir::Files).isEmpty(), 60'000);
        user.request_stop();
        const auto saved = saving.get();
        QVERIFY(!saved.has_value());
        QVERIFY2(saved.error().what.find("cancelled") != std::string::npos, saved.error().text().c_str());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList());
        QVERIFY(writeResults(sampleScan(20), {}, folder.path()).value()[0].contains("_R1_001"));
    }

    void aSaveThatWaitsForAnotherProgramCanBeCancelled() {
        QTemporaryDir folder;
        QLockFile other(folder.filePath(".usar_scan.lock"));
        QVERIFY(other.lock());
        std::stop_source user;
        auto saving = std::async(std::launch::async, [&] {
            return writeResults(sampleScan(20), {}, folder.path(), mapping::HeightLook{}, user.get_token());
        });
        user.request_stop();
        QVERIFY(!saving.get().has_value());
        QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
    }

    void namesBecomeFileNames_data() {
        QTest::addColumn<QString>("level");
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("stem");
        QTest::newRow("plain") << "DM-VMAC1"
                               << "R1"
                               << "USAR_Scan_DM-VMAC1_R1_001";
        QTest::newRow("slashes") << "../../etc"
                                 << "a/b"
                                 << "USAR_Scan_-etc_a-b_001";
        QTest::newRow("nothing") << ""
                                 << ""
                                 << "USAR_Scan_map_robot_001";
        QTest::newRow("only signs") << "***"
                                    << "??"
                                    << "USAR_Scan_map_robot_001";
        QTest::newRow("endless") << QString(500, 'x') << "R"
                                 << "USAR_Scan_" + QString(40, 'x') + "_R_001";
    }

    void namesBecomeFileNames() {
        QFETCH(QString, level);
        QFETCH(QString, robot);
        QFETCH(QString, stem);
        QTemporaryDir folder;
        ScanRecord record = sampleScan(5);
        record.level = level.toStdString();
        record.robot_name = robot.toStdString();
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY2(files.has_value(), files ? "" : files.error().text().c_str());
        QCOMPARE(QFileInfo(ending(*files, ".bil")).completeBaseName(), stem);
        QCOMPARE(QFileInfo(files->first()).absolutePath(), QFileInfo(folder.path()).absoluteFilePath());
    }

    void anUnwritableFolderIsNamed_data() {
        QTest::addColumn<QString>("folder");
        QTest::newRow("no folder") << "";
        QTest::newRow("below a file") << "FILE/results";
        QTest::newRow("is a file") << "FILE";
        QTest::newRow("where nobody may write") << "/proc/results";
        QTest::newRow("a folder without the right to write") << "/proc/self";
    }

    void anUnwritableFolderIsNamed() {
        QFETCH(QString, folder);
        QTemporaryDir temporary;
        QFile file(temporary.filePath("file"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        folder.replace("FILE", file.fileName());
        const auto files = writeResults(sampleScan(20), {}, folder);
        QVERIFY(!files.has_value());
        QCOMPARE(QString::fromStdString(files.error().where), folder);
        QVERIFY(files.error().mend.find("Choose another folder") != std::string::npos);
    }

    void anEmptyMapStillLeavesTheSummary() {
        QTemporaryDir folder;
        ScanRecord record;
        record.level = "tall_test";
        const auto files = writeResults(record, QJsonObject{{"success", false}}, folder.path());
        QVERIFY(!files.has_value());
        QVERIFY(files.error().what.find("nothing was scanned") != std::string::npos);
        const QStringList left = QDir(folder.path()).entryList(QDir::Files);
        QCOMPARE(left.size(), 1);
        QVERIFY(QString::fromStdString(files.error().mend).contains(left[0]));
        const QJsonObject json = readJson(folder.filePath(left[0]));
        QVERIFY(json.contains("success"));
        QCOMPARE(json["map"].toObject()["known_cells"].toInt(), 0);
    }

    void aSquareKilometreIsWrittenWhole() {
        QTemporaryDir folder;
        const ScanRecord record = sampleScan(4000);
        const auto files = writeResults(record, {}, folder.path());
        QVERIFY2(files.has_value(), files ? "" : files.error().text().c_str());
        QCOMPARE(QFileInfo(ending(*files, ".bil")).size(), 4000 * 4000 * 4);
        QCOMPARE(QImageReader(ending(*files, "_height.png")).size(), QSize(4000, 4000));
    }

    void theUsualFolderIsOnTheDesktop() {
        const QString folder = defaultResultFolder();
        QCOMPARE(QFileInfo(folder).fileName(), QString("USAR_Scan"));
        QVERIFY(QDir(QFileInfo(folder).path()).exists());
    }
};

// Without a QGuiApplication, as a headless program may be: pictures must do without letters then.
USAR_TEST(tst_ResultWriter)

} // namespace tst_result_writer

#include "tst_result_writer.moc"
